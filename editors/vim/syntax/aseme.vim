" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_985 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_984 /\v\w+/
syntax match asemeNumber_983 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_982 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_981 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_986 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_981,asemeText_982,asemeNumber_983,asemeReference_984,asemeReference_985,asemePunctuation_986,asemeComment
syntax match asemeReference_32 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_31 /\v\w+/ contained
syntax match asemeNumber_30 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_29 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_28 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_33 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_66,asemeDeclaration_78,asemeDeclaration_104,asemeDeclaration_131,asemeDeclaration_161,asemeDeclaration_184,asemeDeclaration_216,asemeDeclaration_469,asemeDeclaration_745,asemeDeclaration_748,asemeDeclaration_879,asemeDeclaration_939,asemeDeclaration_968,asemeDeclaration_979,asemeText_981,asemeText_982,asemeNumber_983,asemeReference_984,asemeReference_985,asemePunctuation_986,asemeComment
syntax match asemeDeclaration_979 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_978,asemeComment_980 skipwhite skipempty
syntax region asemeComment_980 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_978,asemeComment_980 skipwhite skipempty
syntax match asemeComment_980 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_978,asemeComment_980 skipwhite skipempty
syntax match asemeText_978 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_977 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_975,asemeText_976
syntax match asemeText_976 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_977 skipwhite skipempty
syntax region asemeComment_977 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_977 skipwhite skipempty
syntax match asemeComment_977 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_977 skipwhite skipempty
syntax region asemePunctuation_975 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_958,asemeText_970,asemeNumber_971,asemeReference_972,asemeOperator_973,asemePunctuation_974,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_974 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_973 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_972 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_971 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_970 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_968 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_967,asemeComment_969 skipwhite skipempty
syntax region asemeComment_969 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_967,asemeComment_969 skipwhite skipempty
syntax match asemeComment_969 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_967,asemeComment_969 skipwhite skipempty
syntax match asemeText_967 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_966 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_964,asemeText_965
syntax match asemeText_965 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_966 skipwhite skipempty
syntax region asemeComment_966 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_966 skipwhite skipempty
syntax match asemeComment_966 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_966 skipwhite skipempty
syntax region asemePunctuation_964 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_958,asemeText_959,asemeNumber_960,asemeReference_961,asemeOperator_962,asemePunctuation_963,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_963 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_962 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_961 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_960 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_959 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_958 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_952,asemeText_953,asemeNumber_954,asemeReference_955,asemeOperator_956,asemePunctuation_957,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_957 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_956 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_955 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_954 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_953 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_952 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_946,asemeText_947,asemeNumber_948,asemeReference_949,asemeOperator_950,asemePunctuation_951,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_951 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_950 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_949 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_948 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_947 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_946 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_941,asemeNumber_942,asemeReference_943,asemeOperator_944,asemePunctuation_945,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_945 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_944 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_943 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_942 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_941 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_939 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_938,asemeComment_940 skipwhite skipempty
syntax region asemeComment_940 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_938,asemeComment_940 skipwhite skipempty
syntax match asemeComment_940 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_938,asemeComment_940 skipwhite skipempty
syntax match asemeBlock_938 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_937 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_935,asemeBlock_936
syntax match asemeBlock_936 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_937 skipwhite skipempty
syntax region asemeComment_937 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_937 skipwhite skipempty
syntax match asemeComment_937 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_937 skipwhite skipempty
syntax region asemePunctuation_935 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_934,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_934 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_916 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_913,asemePunctuation_923,asemePunctuation_929,asemePunctuation_932
syntax match asemePunctuation_932 /\v\:/ contained nextgroup=asemeReference_931,asemeComment_933 skipwhite skipempty
syntax region asemeComment_933 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_931,asemeComment_933 skipwhite skipempty
syntax match asemeComment_933 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_931,asemeComment_933 skipwhite skipempty
syntax match asemeReference_931 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_916 skipwhite skipempty
syntax match asemePunctuation_929 /\v\,/ contained nextgroup=asemeName_926,asemeName_928,asemeComment_930 skipwhite skipempty
syntax region asemeComment_930 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_926,asemeName_928,asemeComment_930 skipwhite skipempty
syntax match asemeComment_930 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_926,asemeName_928,asemeComment_930 skipwhite skipempty
syntax match asemeName_928 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_916 skipwhite skipempty
syntax match asemeName_926 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_925,asemeComment_927 skipwhite skipempty
syntax region asemeComment_927 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_925,asemeComment_927 skipwhite skipempty
syntax match asemeComment_927 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_925,asemeComment_927 skipwhite skipempty
syntax match asemeOperator_925 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemePunctuation_923 /\v\[/ contained nextgroup=asemeNumber_921,asemeComment_924 skipwhite skipempty
syntax region asemeComment_924 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_921,asemeComment_924 skipwhite skipempty
syntax match asemeComment_924 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_921,asemeComment_924 skipwhite skipempty
syntax match asemeNumber_921 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_919,asemeComment_922 skipwhite skipempty
syntax region asemeComment_922 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_919,asemeComment_922 skipwhite skipempty
syntax match asemeComment_922 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_919,asemeComment_922 skipwhite skipempty
syntax match asemePunctuation_919 /\v\.\./ contained nextgroup=asemeNumber_917,asemeComment_920 skipwhite skipempty
syntax region asemeComment_920 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_917,asemeComment_920 skipwhite skipempty
syntax match asemeComment_920 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_917,asemeComment_920 skipwhite skipempty
syntax match asemeNumber_917 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_915,asemeComment_918 skipwhite skipempty
syntax region asemeComment_918 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_915,asemeComment_918 skipwhite skipempty
syntax match asemeComment_918 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_915,asemeComment_918 skipwhite skipempty
syntax match asemePunctuation_915 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_916 skipwhite skipempty
syntax region asemeComment_916 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_916 skipwhite skipempty
syntax match asemeComment_916 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_916 skipwhite skipempty
syntax match asemeClause_913 /\vwith%(<|>)/ contained nextgroup=asemeName_911,asemeComment_914 skipwhite skipempty
syntax region asemeComment_914 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_911,asemeComment_914 skipwhite skipempty
syntax match asemeComment_914 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_911,asemeComment_914 skipwhite skipempty
syntax match asemeName_911 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_910,asemeComment_912 skipwhite skipempty
syntax region asemeComment_912 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_910,asemeComment_912 skipwhite skipempty
syntax match asemeComment_912 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_910,asemeComment_912 skipwhite skipempty
syntax match asemeOperator_910 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeDeclaration_879 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_878,asemeComment_880 skipwhite skipempty
syntax region asemeComment_880 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_878,asemeComment_880 skipwhite skipempty
syntax match asemeComment_880 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_878,asemeComment_880 skipwhite skipempty
syntax match asemeBlock_878 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_877 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_875,asemeBlock_876
syntax match asemeBlock_876 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_877 skipwhite skipempty
syntax region asemeComment_877 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_877 skipwhite skipempty
syntax match asemeComment_877 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_877 skipwhite skipempty
syntax region asemePunctuation_875 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_772,asemeNumber_779,asemeDeclaration_813,asemeDeclaration_864,asemeDeclaration_869,asemeDeclaration_871,asemeDeclaration_873,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_873 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_874 skipwhite skipempty
syntax region asemeComment_874 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_874 skipwhite skipempty
syntax match asemeComment_874 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_874 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_718
syntax match asemeDeclaration_871 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_872 skipwhite skipempty
syntax region asemeComment_872 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_872 skipwhite skipempty
syntax match asemeComment_872 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_872 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_671
syntax match asemeDeclaration_869 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_867,asemeComment_870 skipwhite skipempty
syntax region asemeComment_870 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_867,asemeComment_870 skipwhite skipempty
syntax match asemeComment_870 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_867,asemeComment_870 skipwhite skipempty
syntax match asemeName_867 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_866,asemeComment_868 skipwhite skipempty
syntax region asemeComment_868 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_866,asemeComment_868 skipwhite skipempty
syntax match asemeComment_868 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_866,asemeComment_868 skipwhite skipempty
syntax match asemeOperator_866 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_864 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_862,asemeComment_865 skipwhite skipempty
syntax region asemeComment_865 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_862,asemeComment_865 skipwhite skipempty
syntax match asemeComment_865 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_862,asemeComment_865 skipwhite skipempty
syntax match asemeName_862 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_860,asemeComment_863 skipwhite skipempty
syntax region asemeComment_863 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_860,asemeComment_863 skipwhite skipempty
syntax match asemeComment_863 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_860,asemeComment_863 skipwhite skipempty
syntax match asemePunctuation_860 /\v\:/ contained nextgroup=asemeBuiltIn_858,asemeType_859,asemeComment_861 skipwhite skipempty
syntax region asemeComment_861 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_858,asemeType_859,asemeComment_861 skipwhite skipempty
syntax match asemeComment_861 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_858,asemeType_859,asemeComment_861 skipwhite skipempty
syntax match asemeType_859 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeBuiltIn_858 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_818,asemeOperator_849,asemeName_854,asemeBuiltIn_856,asemeType_857
syntax match asemeType_857 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeBuiltIn_856 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeName_854 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_852,asemeComment_855 skipwhite skipempty
syntax region asemeComment_855 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_852,asemeComment_855 skipwhite skipempty
syntax match asemeComment_855 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_852,asemeComment_855 skipwhite skipempty
syntax match asemePunctuation_852 /\v\:/ contained nextgroup=asemeBuiltIn_850,asemeType_851,asemeComment_853 skipwhite skipempty
syntax region asemeComment_853 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_850,asemeType_851,asemeComment_853 skipwhite skipempty
syntax match asemeComment_853 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_850,asemeType_851,asemeComment_853 skipwhite skipempty
syntax match asemeType_851 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeBuiltIn_850 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeOperator_849 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemePunctuation_818 /\v\:/ contained nextgroup=asemeBuiltIn_815,asemeType_817,asemeComment_819 skipwhite skipempty
syntax region asemeComment_819 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_815,asemeType_817,asemeComment_819 skipwhite skipempty
syntax match asemeComment_819 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_815,asemeType_817,asemeComment_819 skipwhite skipempty
syntax match asemeType_817 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeBuiltIn_815 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax region asemeComment_816 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeComment_816 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_816 skipwhite skipempty
syntax match asemeDeclaration_813 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_811,asemeComment_814 skipwhite skipempty
syntax region asemeComment_814 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_811,asemeComment_814 skipwhite skipempty
syntax match asemeComment_814 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_811,asemeComment_814 skipwhite skipempty
syntax match asemeNumber_811 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_810,asemeComment_812 skipwhite skipempty
syntax region asemeComment_812 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_810,asemeComment_812 skipwhite skipempty
syntax match asemeComment_812 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_810,asemeComment_812 skipwhite skipempty
syntax match asemePunctuation_810 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeNumber_779 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_777,asemeComment_780 skipwhite skipempty
syntax region asemeComment_780 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_777,asemeComment_780 skipwhite skipempty
syntax match asemeComment_780 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_777,asemeComment_780 skipwhite skipempty
syntax match asemeOperator_777 /\v\-\>/ contained nextgroup=asemeNumber_775,asemeComment_778 skipwhite skipempty
syntax region asemeComment_778 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_775,asemeComment_778 skipwhite skipempty
syntax match asemeComment_778 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_775,asemeComment_778 skipwhite skipempty
syntax match asemeNumber_775 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_774,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_774,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_774,asemeComment_776 skipwhite skipempty
syntax match asemePunctuation_774 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeDeclaration_772 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_770,asemeComment_773 skipwhite skipempty
syntax region asemeComment_773 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_770,asemeComment_773 skipwhite skipempty
syntax match asemeComment_773 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_770,asemeComment_773 skipwhite skipempty
syntax match asemeNumber_770 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_768,asemeComment_771 skipwhite skipempty
syntax region asemeComment_771 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_768,asemeComment_771 skipwhite skipempty
syntax match asemeComment_771 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_768,asemeComment_771 skipwhite skipempty
syntax match asemeChoice_768 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_766,asemeText_767,@asemeChartNodeInBodyOfStatechart,asemeComment_769 skipwhite skipempty
syntax region asemeComment_769 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_766,asemeText_767,@asemeChartNodeInBodyOfStatechart,asemeComment_769 skipwhite skipempty
syntax match asemeComment_769 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_766,asemeText_767,@asemeChartNodeInBodyOfStatechart,asemeComment_769 skipwhite skipempty
syntax match asemeText_767 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeName_766 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_752,asemeChoice_756,asemeNumber_762,asemeName_764,asemeText_765
syntax match asemeText_765 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeName_764 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeNumber_762 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_760,asemeComment_763 skipwhite skipempty
syntax region asemeComment_763 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_760,asemeComment_763 skipwhite skipempty
syntax match asemeComment_763 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_760,asemeComment_763 skipwhite skipempty
syntax match asemeChoice_760 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_758,asemeText_759,@asemeChartNodeInBodyOfStatechart,asemeComment_761 skipwhite skipempty
syntax region asemeComment_761 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_758,asemeText_759,@asemeChartNodeInBodyOfStatechart,asemeComment_761 skipwhite skipempty
syntax match asemeComment_761 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_758,asemeText_759,@asemeChartNodeInBodyOfStatechart,asemeComment_761 skipwhite skipempty
syntax match asemeText_759 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeName_758 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeChoice_756 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_754,asemeText_755,@asemeChartNodeInBodyOfStatechart,asemeComment_757 skipwhite skipempty
syntax region asemeComment_757 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_754,asemeText_755,@asemeChartNodeInBodyOfStatechart,asemeComment_757 skipwhite skipempty
syntax match asemeComment_757 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_754,asemeText_755,@asemeChartNodeInBodyOfStatechart,asemeComment_757 skipwhite skipempty
syntax match asemeText_755 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeName_754 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeClause_752 /\vactivity%(<|>)/ contained nextgroup=asemeReference_750,asemeComment_753 skipwhite skipempty
syntax region asemeComment_753 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_750,asemeComment_753 skipwhite skipempty
syntax match asemeComment_753 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_750,asemeComment_753 skipwhite skipempty
syntax match asemeReference_750 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax region asemeComment_751 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeComment_751 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_751 skipwhite skipempty
syntax match asemeDeclaration_748 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_747,asemeComment_749 skipwhite skipempty
syntax region asemeComment_749 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_747,asemeComment_749 skipwhite skipempty
syntax match asemeComment_749 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_747,asemeComment_749 skipwhite skipempty
syntax match asemeBlock_747 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax match asemeDeclaration_745 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_743,asemeComment_746 skipwhite skipempty
syntax region asemeComment_746 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_743,asemeComment_746 skipwhite skipempty
syntax match asemeComment_746 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_743,asemeComment_746 skipwhite skipempty
syntax match asemeClause_743 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_742,asemeComment_744 skipwhite skipempty
syntax region asemeComment_744 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_742,asemeComment_744 skipwhite skipempty
syntax match asemeComment_744 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_742,asemeComment_744 skipwhite skipempty
syntax match asemeBlock_742 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_473,asemePunctuation_740,asemeBlock_741
syntax match asemeBlock_741 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax region asemePunctuation_740 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_481,asemeDeclaration_517,asemeDeclaration_533,asemeDeclaration_584,asemeDeclaration_589,asemeDeclaration_613,asemeDeclaration_672,asemeDeclaration_719,asemeDeclaration_728,asemeDeclaration_738,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_738 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_736,asemeComment_739 skipwhite skipempty
syntax region asemeComment_739 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_736,asemeComment_739 skipwhite skipempty
syntax match asemeComment_739 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_736,asemeComment_739 skipwhite skipempty
syntax match asemeBlock_736 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_735,@asemeControlInBodyOfSrm,asemeComment_737 skipwhite skipempty
syntax region asemeComment_737 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_735,@asemeControlInBodyOfSrm,asemeComment_737 skipwhite skipempty
syntax match asemeComment_737 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_735,@asemeControlInBodyOfSrm,asemeComment_737 skipwhite skipempty
syntax match asemeOperator_735 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_454,asemeOperator_730,asemeBlock_733
syntax match asemeBlock_733 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_732,@asemeControlInBodyOfSrm,asemeComment_734 skipwhite skipempty
syntax region asemeComment_734 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_732,@asemeControlInBodyOfSrm,asemeComment_734 skipwhite skipempty
syntax match asemeComment_734 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_732,@asemeControlInBodyOfSrm,asemeComment_734 skipwhite skipempty
syntax match asemeOperator_732 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeOperator_730 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeDeclaration_728 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_727,asemeComment_729 skipwhite skipempty
syntax region asemeComment_729 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_727,asemeComment_729 skipwhite skipempty
syntax match asemeComment_729 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_727,asemeComment_729 skipwhite skipempty
syntax match asemeBlock_727 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_726 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_724,asemeBlock_725
syntax match asemeBlock_725 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_726 skipwhite skipempty
syntax region asemeComment_726 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_726 skipwhite skipempty
syntax match asemeComment_726 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_726 skipwhite skipempty
syntax region asemePunctuation_724 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_722,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_722 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax region asemeComment_723 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax match asemeComment_723 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax match asemeText_721 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_719 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_720 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_718
syntax region asemePunctuation_718 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_717,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_717 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_679,asemeClause_682,asemeClause_685,asemeClause_688,asemeClause_691,asemeClause_694,asemeClause_697,asemeClause_700,asemeClause_703,asemeClause_705,asemePunctuation_712,asemeOperator_715
syntax match asemeOperator_715 /\v\=%(\=)@!/ contained nextgroup=asemeText_714,asemeComment_716 skipwhite skipempty
syntax region asemeComment_716 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_714,asemeComment_716 skipwhite skipempty
syntax match asemeComment_716 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_714,asemeComment_716 skipwhite skipempty
syntax match asemeText_714 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemePunctuation_712 /\v\,/ contained nextgroup=asemeChoice_707,asemeReference_709,asemeReference_710,asemeReference_711,asemeComment_713 skipwhite skipempty
syntax region asemeComment_713 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_707,asemeReference_709,asemeReference_710,asemeReference_711,asemeComment_713 skipwhite skipempty
syntax match asemeComment_713 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_707,asemeReference_709,asemeReference_710,asemeReference_711,asemeComment_713 skipwhite skipempty
syntax match asemeReference_711 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeReference_710 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeReference_709 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeChoice_707 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_706,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_706,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_706,asemeComment_708 skipwhite skipempty
syntax match asemeReference_706 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_705 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_703 /\vends%(<|>)/ contained nextgroup=asemeReference_702,asemeComment_704 skipwhite skipempty
syntax region asemeComment_704 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_702,asemeComment_704 skipwhite skipempty
syntax match asemeComment_704 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_702,asemeComment_704 skipwhite skipempty
syntax match asemeReference_702 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_700 /\vwrites%(<|>)/ contained nextgroup=asemeReference_699,asemeComment_701 skipwhite skipempty
syntax region asemeComment_701 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_699,asemeComment_701 skipwhite skipempty
syntax match asemeComment_701 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_699,asemeComment_701 skipwhite skipempty
syntax match asemeReference_699 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_697 /\vfor%(<|>)/ contained nextgroup=asemeNumber_696,asemeComment_698 skipwhite skipempty
syntax region asemeComment_698 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_696,asemeComment_698 skipwhite skipempty
syntax match asemeComment_698 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_696,asemeComment_698 skipwhite skipempty
syntax match asemeNumber_696 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_694 /\vuses%(<|>)/ contained nextgroup=asemeReference_693,asemeComment_695 skipwhite skipempty
syntax region asemeComment_695 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_693,asemeComment_695 skipwhite skipempty
syntax match asemeComment_695 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_693,asemeComment_695 skipwhite skipempty
syntax match asemeReference_693 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_691 /\vas%(<|>)/ contained nextgroup=asemeChoice_690,asemeComment_692 skipwhite skipempty
syntax region asemeComment_692 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_690,asemeComment_692 skipwhite skipempty
syntax match asemeComment_692 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_690,asemeComment_692 skipwhite skipempty
syntax match asemeChoice_690 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_688 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_687,asemeComment_689 skipwhite skipempty
syntax region asemeComment_689 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_687,asemeComment_689 skipwhite skipempty
syntax match asemeComment_689 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_687,asemeComment_689 skipwhite skipempty
syntax match asemeNumber_687 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_685 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_684,asemeComment_686 skipwhite skipempty
syntax region asemeComment_686 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_684,asemeComment_686 skipwhite skipempty
syntax match asemeComment_686 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_684,asemeComment_686 skipwhite skipempty
syntax match asemeNumber_684 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_682 /\vevery%(<|>)/ contained nextgroup=asemeNumber_681,asemeComment_683 skipwhite skipempty
syntax region asemeComment_683 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_681,asemeComment_683 skipwhite skipempty
syntax match asemeComment_683 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_681,asemeComment_683 skipwhite skipempty
syntax match asemeNumber_681 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeClause_679 /\vreads%(<|>)/ contained nextgroup=asemeChoice_676,asemeReference_678,asemeComment_680 skipwhite skipempty
syntax region asemeComment_680 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_676,asemeReference_678,asemeComment_680 skipwhite skipempty
syntax match asemeComment_680 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_676,asemeReference_678,asemeComment_680 skipwhite skipempty
syntax match asemeReference_678 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeChoice_676 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_674,asemeComment_677 skipwhite skipempty
syntax region asemeComment_677 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_674,asemeComment_677 skipwhite skipempty
syntax match asemeComment_677 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_674,asemeComment_677 skipwhite skipempty
syntax match asemeReference_674 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax region asemeComment_675 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeComment_675 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_675 skipwhite skipempty
syntax match asemeDeclaration_672 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_673 skipwhite skipempty
syntax region asemeComment_673 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_673 skipwhite skipempty
syntax match asemeComment_673 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_673 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_671
syntax region asemePunctuation_671 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_670,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_670 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_620,asemeClause_623,asemeClause_626,asemeClause_629,asemeClause_632,asemeClause_635,asemeClause_638,asemeClause_641,asemeClause_644,asemeClause_646,asemePunctuation_653,asemePunctuation_667,asemePunctuation_669
syntax match asemePunctuation_669 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemePunctuation_667 /\v\,/ contained nextgroup=asemeName_659,asemeChoice_662,asemeReference_664,asemeReference_665,asemeReference_666,asemeComment_668 skipwhite skipempty
syntax region asemeComment_668 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_659,asemeChoice_662,asemeReference_664,asemeReference_665,asemeReference_666,asemeComment_668 skipwhite skipempty
syntax match asemeComment_668 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_659,asemeChoice_662,asemeReference_664,asemeReference_665,asemeReference_666,asemeComment_668 skipwhite skipempty
syntax match asemeReference_666 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeReference_665 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeReference_664 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeChoice_662 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_661,asemeComment_663 skipwhite skipempty
syntax region asemeComment_663 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_661,asemeComment_663 skipwhite skipempty
syntax match asemeComment_663 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_661,asemeComment_663 skipwhite skipempty
syntax match asemeReference_661 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeName_659 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_657,asemeComment_660 skipwhite skipempty
syntax region asemeComment_660 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_657,asemeComment_660 skipwhite skipempty
syntax match asemeComment_660 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_657,asemeComment_660 skipwhite skipempty
syntax match asemePunctuation_657 /\v\:/ contained nextgroup=asemeBuiltIn_655,asemeType_656,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_655,asemeType_656,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_655,asemeType_656,asemeComment_658 skipwhite skipempty
syntax match asemeType_656 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeBuiltIn_655 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemePunctuation_653 /\v\(/ contained nextgroup=asemeName_651,asemeComment_654 skipwhite skipempty
syntax region asemeComment_654 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_651,asemeComment_654 skipwhite skipempty
syntax match asemeComment_654 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_651,asemeComment_654 skipwhite skipempty
syntax match asemeName_651 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_649,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_649,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_649,asemeComment_652 skipwhite skipempty
syntax match asemePunctuation_649 /\v\:/ contained nextgroup=asemeBuiltIn_647,asemeType_648,asemeComment_650 skipwhite skipempty
syntax region asemeComment_650 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_647,asemeType_648,asemeComment_650 skipwhite skipempty
syntax match asemeComment_650 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_647,asemeType_648,asemeComment_650 skipwhite skipempty
syntax match asemeType_648 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeBuiltIn_647 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_646 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_644 /\vends%(<|>)/ contained nextgroup=asemeReference_643,asemeComment_645 skipwhite skipempty
syntax region asemeComment_645 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_643,asemeComment_645 skipwhite skipempty
syntax match asemeComment_645 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_643,asemeComment_645 skipwhite skipempty
syntax match asemeReference_643 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_641 /\vwrites%(<|>)/ contained nextgroup=asemeReference_640,asemeComment_642 skipwhite skipempty
syntax region asemeComment_642 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_640,asemeComment_642 skipwhite skipempty
syntax match asemeComment_642 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_640,asemeComment_642 skipwhite skipempty
syntax match asemeReference_640 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_638 /\vfor%(<|>)/ contained nextgroup=asemeNumber_637,asemeComment_639 skipwhite skipempty
syntax region asemeComment_639 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_637,asemeComment_639 skipwhite skipempty
syntax match asemeComment_639 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_637,asemeComment_639 skipwhite skipempty
syntax match asemeNumber_637 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_635 /\vuses%(<|>)/ contained nextgroup=asemeReference_634,asemeComment_636 skipwhite skipempty
syntax region asemeComment_636 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_634,asemeComment_636 skipwhite skipempty
syntax match asemeComment_636 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_634,asemeComment_636 skipwhite skipempty
syntax match asemeReference_634 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_632 /\vas%(<|>)/ contained nextgroup=asemeChoice_631,asemeComment_633 skipwhite skipempty
syntax region asemeComment_633 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_631,asemeComment_633 skipwhite skipempty
syntax match asemeComment_633 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_631,asemeComment_633 skipwhite skipempty
syntax match asemeChoice_631 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_629 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_628,asemeComment_630 skipwhite skipempty
syntax region asemeComment_630 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_628,asemeComment_630 skipwhite skipempty
syntax match asemeComment_630 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_628,asemeComment_630 skipwhite skipempty
syntax match asemeNumber_628 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_626 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_625,asemeComment_627 skipwhite skipempty
syntax region asemeComment_627 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_625,asemeComment_627 skipwhite skipempty
syntax match asemeComment_627 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_625,asemeComment_627 skipwhite skipempty
syntax match asemeNumber_625 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_623 /\vevery%(<|>)/ contained nextgroup=asemeNumber_622,asemeComment_624 skipwhite skipempty
syntax region asemeComment_624 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_622,asemeComment_624 skipwhite skipempty
syntax match asemeComment_624 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_622,asemeComment_624 skipwhite skipempty
syntax match asemeNumber_622 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeClause_620 /\vreads%(<|>)/ contained nextgroup=asemeChoice_617,asemeReference_619,asemeComment_621 skipwhite skipempty
syntax region asemeComment_621 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_617,asemeReference_619,asemeComment_621 skipwhite skipempty
syntax match asemeComment_621 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_617,asemeReference_619,asemeComment_621 skipwhite skipempty
syntax match asemeReference_619 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeChoice_617 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_615,asemeComment_618 skipwhite skipempty
syntax region asemeComment_618 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_615,asemeComment_618 skipwhite skipempty
syntax match asemeComment_618 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_615,asemeComment_618 skipwhite skipempty
syntax match asemeReference_615 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax region asemeComment_616 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeComment_616 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_616 skipwhite skipempty
syntax match asemeDeclaration_613 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_614 skipwhite skipempty
syntax region asemeComment_614 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_614 skipwhite skipempty
syntax match asemeComment_614 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_614 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_612
syntax region asemePunctuation_612 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_611,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_611 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_593,asemePunctuation_597,asemePunctuation_600,asemePunctuation_602,asemeOperator_610
syntax match asemeOperator_610 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemePunctuation_602 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax match asemePunctuation_600 /\v\,/ contained nextgroup=asemeName_599,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_599,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_599,asemeComment_601 skipwhite skipempty
syntax match asemeName_599 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax match asemePunctuation_597 /\v\:/ contained nextgroup=asemeBuiltIn_595,asemeType_596,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_595,asemeType_596,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_595,asemeType_596,asemeComment_598 skipwhite skipempty
syntax match asemeType_596 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax match asemeBuiltIn_595 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax match asemePunctuation_593 /\v\(/ contained nextgroup=asemeName_591,asemeComment_594 skipwhite skipempty
syntax region asemeComment_594 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_591,asemeComment_594 skipwhite skipempty
syntax match asemeComment_594 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_591,asemeComment_594 skipwhite skipempty
syntax match asemeName_591 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_592 skipwhite skipempty
syntax match asemeDeclaration_589 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_587,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_587,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_587,asemeComment_590 skipwhite skipempty
syntax match asemeName_587 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_586,asemeComment_588 skipwhite skipempty
syntax region asemeComment_588 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_586,asemeComment_588 skipwhite skipempty
syntax match asemeComment_588 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_586,asemeComment_588 skipwhite skipempty
syntax match asemeOperator_586 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_584 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_582,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_582,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_582,asemeComment_585 skipwhite skipempty
syntax match asemeName_582 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_580,asemeComment_583 skipwhite skipempty
syntax region asemeComment_583 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_580,asemeComment_583 skipwhite skipempty
syntax match asemeComment_583 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_580,asemeComment_583 skipwhite skipempty
syntax match asemePunctuation_580 /\v\:/ contained nextgroup=asemeBuiltIn_578,asemeType_579,asemeComment_581 skipwhite skipempty
syntax region asemeComment_581 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_578,asemeType_579,asemeComment_581 skipwhite skipempty
syntax match asemeComment_581 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_578,asemeType_579,asemeComment_581 skipwhite skipempty
syntax match asemeType_579 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_578 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_538,asemeOperator_569,asemeName_574,asemeBuiltIn_576,asemeType_577
syntax match asemeType_577 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_576 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeName_574 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_572,asemeComment_575 skipwhite skipempty
syntax region asemeComment_575 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_572,asemeComment_575 skipwhite skipempty
syntax match asemeComment_575 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_572,asemeComment_575 skipwhite skipempty
syntax match asemePunctuation_572 /\v\:/ contained nextgroup=asemeBuiltIn_570,asemeType_571,asemeComment_573 skipwhite skipempty
syntax region asemeComment_573 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_570,asemeType_571,asemeComment_573 skipwhite skipempty
syntax match asemeComment_573 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_570,asemeType_571,asemeComment_573 skipwhite skipempty
syntax match asemeType_571 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_570 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeOperator_569 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemePunctuation_538 /\v\:/ contained nextgroup=asemeBuiltIn_535,asemeType_537,asemeComment_539 skipwhite skipempty
syntax region asemeComment_539 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_535,asemeType_537,asemeComment_539 skipwhite skipempty
syntax match asemeComment_539 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_535,asemeType_537,asemeComment_539 skipwhite skipempty
syntax match asemeType_537 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_535 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax region asemeComment_536 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeComment_536 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeDeclaration_533 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax region asemeComment_534 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax match asemeComment_534 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax match asemeName_531 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_530,@asemeCapabilityInBodyOfSrm,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_530,@asemeCapabilityInBodyOfSrm,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_530,@asemeCapabilityInBodyOfSrm,asemeComment_532 skipwhite skipempty
syntax match asemeText_530 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_521,asemePunctuation_524,asemeText_526,asemeName_528
syntax match asemeName_528 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_527,@asemeCapabilityInBodyOfSrm,asemeComment_529 skipwhite skipempty
syntax region asemeComment_529 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_527,@asemeCapabilityInBodyOfSrm,asemeComment_529 skipwhite skipempty
syntax match asemeComment_529 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_527,@asemeCapabilityInBodyOfSrm,asemeComment_529 skipwhite skipempty
syntax match asemeText_527 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax match asemeText_526 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax match asemePunctuation_524 /\v\,/ contained nextgroup=asemeReference_523,asemeComment_525 skipwhite skipempty
syntax region asemeComment_525 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_523,asemeComment_525 skipwhite skipempty
syntax match asemeComment_525 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_523,asemeComment_525 skipwhite skipempty
syntax match asemeReference_523 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax match asemeOperator_521 /\v\=%(\=)@!/ contained nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax region asemeComment_522 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax match asemeComment_522 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax match asemeReference_519 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax region asemeComment_520 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax match asemeComment_520 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_520 skipwhite skipempty
syntax match asemeDeclaration_517 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_515,asemeComment_518 skipwhite skipempty
syntax region asemeComment_518 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_515,asemeComment_518 skipwhite skipempty
syntax match asemeComment_518 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_515,asemeComment_518 skipwhite skipempty
syntax match asemeReference_515 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_513,asemeComment_516 skipwhite skipempty
syntax region asemeComment_516 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_513,asemeComment_516 skipwhite skipempty
syntax match asemeComment_516 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_513,asemeComment_516 skipwhite skipempty
syntax match asemePunctuation_513 /\v\./ contained nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax match asemeReference_512 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_489,asemeClause_492,asemePunctuation_502,asemePunctuation_505,asemeReference_510
syntax match asemeReference_510 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_508,@asemePlaysInBodyOfSrm,asemeComment_511 skipwhite skipempty
syntax region asemeComment_511 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_508,@asemePlaysInBodyOfSrm,asemeComment_511 skipwhite skipempty
syntax match asemeComment_511 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_508,@asemePlaysInBodyOfSrm,asemeComment_511 skipwhite skipempty
syntax match asemePunctuation_508 /\v\./ contained nextgroup=asemeReference_507,asemeComment_509 skipwhite skipempty
syntax region asemeComment_509 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_507,asemeComment_509 skipwhite skipempty
syntax match asemeComment_509 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_507,asemeComment_509 skipwhite skipempty
syntax match asemeReference_507 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemePunctuation_505 /\v\./ contained nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax region asemeComment_506 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax match asemeComment_506 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax match asemeReference_504 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemePunctuation_502 /\v\,/ contained nextgroup=asemeReference_500,asemeComment_503 skipwhite skipempty
syntax region asemeComment_503 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_500,asemeComment_503 skipwhite skipempty
syntax match asemeComment_503 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_500,asemeComment_503 skipwhite skipempty
syntax match asemeReference_500 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\=%(\=)@!|\.))@=/ contained nextgroup=asemeOperator_495,asemePunctuation_498,asemeComment_501 skipwhite skipempty
syntax region asemeComment_501 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_495,asemePunctuation_498,asemeComment_501 skipwhite skipempty
syntax match asemeComment_501 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_495,asemePunctuation_498,asemeComment_501 skipwhite skipempty
syntax match asemePunctuation_498 /\v\./ contained nextgroup=asemeReference_497,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_497,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_497,asemeComment_499 skipwhite skipempty
syntax match asemeReference_497 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemeOperator_495 /\v\=%(\=)@!/ contained nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax region asemeComment_496 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeComment_496 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeReference_494 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemeClause_492 /\vas%(<|>)/ contained nextgroup=asemeReference_491,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_491,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_491,asemeComment_493 skipwhite skipempty
syntax match asemeReference_491 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemeClause_489 /\vwith%(<|>)/ contained nextgroup=asemeReference_487,asemeComment_490 skipwhite skipempty
syntax region asemeComment_490 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_487,asemeComment_490 skipwhite skipempty
syntax match asemeComment_490 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_487,asemeComment_490 skipwhite skipempty
syntax match asemeReference_487 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_485,asemeComment_488 skipwhite skipempty
syntax region asemeComment_488 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_485,asemeComment_488 skipwhite skipempty
syntax match asemeComment_488 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_485,asemeComment_488 skipwhite skipempty
syntax match asemeOperator_485 /\v\=%(\=)@!/ contained nextgroup=asemeReference_483,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_483,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_483,asemeComment_486 skipwhite skipempty
syntax match asemeReference_483 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax region asemeComment_484 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemeComment_484 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_484 skipwhite skipempty
syntax match asemeDeclaration_481 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_480,asemeComment_482 skipwhite skipempty
syntax region asemeComment_482 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_480,asemeComment_482 skipwhite skipempty
syntax match asemeComment_482 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_480,asemeComment_482 skipwhite skipempty
syntax match asemeReference_480 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_476 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_477,asemeReference_479
syntax match asemeReference_479 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_476 skipwhite skipempty
syntax match asemePunctuation_477 /\v\,/ contained nextgroup=asemeReference_475,asemeComment_478 skipwhite skipempty
syntax region asemeComment_478 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_475,asemeComment_478 skipwhite skipempty
syntax match asemeComment_478 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_475,asemeComment_478 skipwhite skipempty
syntax match asemeReference_475 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_476 skipwhite skipempty
syntax region asemeComment_476 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_476 skipwhite skipempty
syntax match asemeComment_476 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_476 skipwhite skipempty
syntax match asemeClause_473 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_471,asemeComment_474 skipwhite skipempty
syntax region asemeComment_474 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_471,asemeComment_474 skipwhite skipempty
syntax match asemeComment_474 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_471,asemeComment_474 skipwhite skipempty
syntax match asemeBlock_471 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax region asemeComment_472 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax match asemeComment_472 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax match asemeDeclaration_469 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_468,asemeComment_470 skipwhite skipempty
syntax region asemeComment_470 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_468,asemeComment_470 skipwhite skipempty
syntax match asemeComment_470 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_468,asemeComment_470 skipwhite skipempty
syntax match asemeBlock_468 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_467 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_465,asemeBlock_466
syntax match asemeBlock_466 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_467 skipwhite skipempty
syntax region asemeComment_467 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_467 skipwhite skipempty
syntax match asemeComment_467 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_467 skipwhite skipempty
syntax region asemePunctuation_465 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_337,asemeDeclaration_340,asemeDeclaration_368,asemeDeclaration_372,asemeDeclaration_463,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_463 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_461,asemeComment_464 skipwhite skipempty
syntax region asemeComment_464 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_461,asemeComment_464 skipwhite skipempty
syntax match asemeComment_464 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_461,asemeComment_464 skipwhite skipempty
syntax match asemeBlock_461 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_460,@asemeControlInBodyOfAip,asemeComment_462 skipwhite skipempty
syntax region asemeComment_462 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_460,@asemeControlInBodyOfAip,asemeComment_462 skipwhite skipempty
syntax match asemeComment_462 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_460,@asemeControlInBodyOfAip,asemeComment_462 skipwhite skipempty
syntax match asemeOperator_460 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_456 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_454,asemeOperator_455,asemeBlock_458
syntax match asemeBlock_458 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_457,@asemeControlInBodyOfAip,asemeComment_459 skipwhite skipempty
syntax region asemeComment_459 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_457,@asemeControlInBodyOfAip,asemeComment_459 skipwhite skipempty
syntax match asemeComment_459 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_457,@asemeControlInBodyOfAip,asemeComment_459 skipwhite skipempty
syntax match asemeOperator_457 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_456 skipwhite skipempty
syntax match asemeOperator_455 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_456 skipwhite skipempty
syntax region asemeComment_456 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_456 skipwhite skipempty
syntax match asemeComment_456 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_456 skipwhite skipempty
syntax region asemePunctuation_454 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_417,asemeNumber_452,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeNumber_452 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_450,asemeComment_453 skipwhite skipempty
syntax region asemeComment_453 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_450,asemeComment_453 skipwhite skipempty
syntax match asemeComment_453 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_450,asemeComment_453 skipwhite skipempty
syntax match asemeOperator_450 /\v\-\>/ contained nextgroup=asemeNumber_448,asemeComment_451 skipwhite skipempty
syntax region asemeComment_451 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_448,asemeComment_451 skipwhite skipempty
syntax match asemeComment_451 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_448,asemeComment_451 skipwhite skipempty
syntax match asemeNumber_448 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_447,asemeComment_449 skipwhite skipempty
syntax region asemeComment_449 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_447,asemeComment_449 skipwhite skipempty
syntax match asemeComment_449 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_447,asemeComment_449 skipwhite skipempty
syntax match asemePunctuation_447 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeDeclaration_417 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_376,asemeOperator_379,asemePunctuation_410,asemeText_411,asemeNumber_412,asemeReference_413,asemeNumber_414,asemeOperator_415,asemePunctuation_416
syntax match asemePunctuation_416 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeOperator_415 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeNumber_414 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeReference_413 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeNumber_412 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeText_411 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemePunctuation_410 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeOperator_379 /\v\#/ contained nextgroup=asemeNumber_378,asemeComment_380 skipwhite skipempty
syntax region asemeComment_380 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_378,asemeComment_380 skipwhite skipempty
syntax match asemeComment_380 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_378,asemeComment_380 skipwhite skipempty
syntax match asemeNumber_378 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeClause_376 /\vevery%(<|>)/ contained nextgroup=asemeNumber_374,asemeComment_377 skipwhite skipempty
syntax region asemeComment_377 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_374,asemeComment_377 skipwhite skipempty
syntax match asemeComment_377 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_374,asemeComment_377 skipwhite skipempty
syntax match asemeNumber_374 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax region asemeComment_375 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeComment_375 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeDeclaration_372 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_370,asemeComment_373 skipwhite skipempty
syntax region asemeComment_373 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_370,asemeComment_373 skipwhite skipempty
syntax match asemeComment_373 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_370,asemeComment_373 skipwhite skipempty
syntax match asemeName_370 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_369,asemeComment_371 skipwhite skipempty
syntax region asemeComment_371 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_369,asemeComment_371 skipwhite skipempty
syntax match asemeComment_371 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_369,asemeComment_371 skipwhite skipempty
syntax match asemeOperator_369 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_368 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_347,asemeClause_350,asemeClause_353,asemeClause_356,asemeClause_358,asemeClause_359,asemePunctuation_361,asemeOperator_364,asemePunctuation_366,asemeName_367
syntax match asemeName_367 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemePunctuation_366 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeOperator_364 /\v\@/ contained nextgroup=asemeReference_363,asemeComment_365 skipwhite skipempty
syntax region asemeComment_365 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_363,asemeComment_365 skipwhite skipempty
syntax match asemeComment_365 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_363,asemeComment_365 skipwhite skipempty
syntax match asemeReference_363 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemePunctuation_361 /\v\(/ contained nextgroup=asemeName_360,asemeComment_362 skipwhite skipempty
syntax region asemeComment_362 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_360,asemeComment_362 skipwhite skipempty
syntax match asemeComment_362 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_360,asemeComment_362 skipwhite skipempty
syntax match asemeName_360 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeClause_359 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeClause_358 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeClause_356 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_355,asemeComment_357 skipwhite skipempty
syntax region asemeComment_357 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_355,asemeComment_357 skipwhite skipempty
syntax match asemeComment_357 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_355,asemeComment_357 skipwhite skipempty
syntax match asemeNumber_355 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeClause_353 /\vleads%(<|>)/ contained nextgroup=asemeClause_352,asemeComment_354 skipwhite skipempty
syntax region asemeComment_354 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_352,asemeComment_354 skipwhite skipempty
syntax match asemeComment_354 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_352,asemeComment_354 skipwhite skipempty
syntax match asemeClause_352 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeClause_350 /\vor%(<|>)/ contained nextgroup=asemeName_349,asemeComment_351 skipwhite skipempty
syntax region asemeComment_351 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_349,asemeComment_351 skipwhite skipempty
syntax match asemeComment_351 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_349,asemeComment_351 skipwhite skipempty
syntax match asemeName_349 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeClause_347 /\vat%(<|>)/ contained nextgroup=asemeClause_345,asemeComment_348 skipwhite skipempty
syntax region asemeComment_348 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_345,asemeComment_348 skipwhite skipempty
syntax match asemeComment_348 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_345,asemeComment_348 skipwhite skipempty
syntax match asemeClause_345 /\vmost%(<|>)/ contained nextgroup=asemeChoice_342,asemeNumber_344,asemeComment_346 skipwhite skipempty
syntax region asemeComment_346 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_342,asemeNumber_344,asemeComment_346 skipwhite skipempty
syntax match asemeComment_346 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_342,asemeNumber_344,asemeComment_346 skipwhite skipempty
syntax match asemeNumber_344 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeChoice_342 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax region asemeComment_343 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeComment_343 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_343 skipwhite skipempty
syntax match asemeDeclaration_340 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_339,asemeComment_341 skipwhite skipempty
syntax region asemeComment_341 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_339,asemeComment_341 skipwhite skipempty
syntax match asemeComment_341 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_339,asemeComment_341 skipwhite skipempty
syntax match asemeText_339 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_337 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_336,asemeComment_338 skipwhite skipempty
syntax region asemeComment_338 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_336,asemeComment_338 skipwhite skipempty
syntax match asemeComment_338 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_336,asemeComment_338 skipwhite skipempty
syntax match asemeBlock_336 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_220,asemePunctuation_223,asemePunctuation_225,asemePunctuation_334,asemeBlock_335
syntax match asemeBlock_335 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax region asemePunctuation_334 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_227,asemeDeclaration_278,asemeDeclaration_283,asemeDeclaration_297,asemeDeclaration_311,asemeName_333,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_333 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_315,asemePunctuation_319,asemePunctuation_322,asemePunctuation_324,asemeOperator_332
syntax match asemeOperator_332 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemePunctuation_324 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemePunctuation_322 /\v\,/ contained nextgroup=asemeName_321,asemeComment_323 skipwhite skipempty
syntax region asemeComment_323 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_321,asemeComment_323 skipwhite skipempty
syntax match asemeComment_323 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_321,asemeComment_323 skipwhite skipempty
syntax match asemeName_321 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemePunctuation_319 /\v\:/ contained nextgroup=asemeBuiltIn_317,asemeType_318,asemeComment_320 skipwhite skipempty
syntax region asemeComment_320 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_317,asemeType_318,asemeComment_320 skipwhite skipempty
syntax match asemeComment_320 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_317,asemeType_318,asemeComment_320 skipwhite skipempty
syntax match asemeType_318 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemeBuiltIn_317 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemePunctuation_315 /\v\(/ contained nextgroup=asemeName_313,asemeComment_316 skipwhite skipempty
syntax region asemeComment_316 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_313,asemeComment_316 skipwhite skipempty
syntax match asemeComment_316 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_313,asemeComment_316 skipwhite skipempty
syntax match asemeName_313 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax region asemeComment_314 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemeComment_314 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemeDeclaration_311 /\v%(receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_309,asemeComment_312 skipwhite skipempty
syntax region asemeComment_312 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_309,asemeComment_312 skipwhite skipempty
syntax match asemeComment_312 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_309,asemeComment_312 skipwhite skipempty
syntax match asemeReference_309 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_308,asemeComment_310 skipwhite skipempty
syntax region asemeComment_310 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_308,asemeComment_310 skipwhite skipempty
syntax match asemeComment_310 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_308,asemeComment_310 skipwhite skipempty
syntax match asemeReference_308 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_303,asemeReference_306
syntax match asemeReference_306 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_305,@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax region asemeComment_307 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_305,@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemeComment_307 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_305,@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemeReference_305 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax match asemePunctuation_303 /\v\,/ contained nextgroup=asemeReference_301,asemeComment_304 skipwhite skipempty
syntax region asemeComment_304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_301,asemeComment_304 skipwhite skipempty
syntax match asemeComment_304 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_301,asemeComment_304 skipwhite skipempty
syntax match asemeReference_301 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_299,asemeComment_302 skipwhite skipempty
syntax region asemeComment_302 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_299,asemeComment_302 skipwhite skipempty
syntax match asemeComment_302 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_299,asemeComment_302 skipwhite skipempty
syntax match asemeReference_299 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax region asemeComment_300 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax match asemeComment_300 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax match asemeDeclaration_297 /\v%(sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_295,asemeComment_298 skipwhite skipempty
syntax region asemeComment_298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_295,asemeComment_298 skipwhite skipempty
syntax match asemeComment_298 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_295,asemeComment_298 skipwhite skipempty
syntax match asemeReference_295 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_294,asemeComment_296 skipwhite skipempty
syntax region asemeComment_296 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_294,asemeComment_296 skipwhite skipempty
syntax match asemeComment_296 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_294,asemeComment_296 skipwhite skipempty
syntax match asemeReference_294 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemePunctuation_289,asemeReference_292
syntax match asemeReference_292 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_291,@asemeSendsInBodyOfParticipant,asemeComment_293 skipwhite skipempty
syntax region asemeComment_293 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_291,@asemeSendsInBodyOfParticipant,asemeComment_293 skipwhite skipempty
syntax match asemeComment_293 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_291,@asemeSendsInBodyOfParticipant,asemeComment_293 skipwhite skipempty
syntax match asemeReference_291 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemePunctuation_289 /\v\,/ contained nextgroup=asemeReference_287,asemeComment_290 skipwhite skipempty
syntax region asemeComment_290 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_287,asemeComment_290 skipwhite skipempty
syntax match asemeComment_290 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_287,asemeComment_290 skipwhite skipempty
syntax match asemeReference_287 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_285,asemeComment_288 skipwhite skipempty
syntax region asemeComment_288 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_285,asemeComment_288 skipwhite skipempty
syntax match asemeComment_288 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_285,asemeComment_288 skipwhite skipempty
syntax match asemeReference_285 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax region asemeComment_286 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemeComment_286 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemeDeclaration_283 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_281,asemeComment_284 skipwhite skipempty
syntax region asemeComment_284 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_281,asemeComment_284 skipwhite skipempty
syntax match asemeComment_284 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_281,asemeComment_284 skipwhite skipempty
syntax match asemeName_281 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_280,asemeComment_282 skipwhite skipempty
syntax region asemeComment_282 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_280,asemeComment_282 skipwhite skipempty
syntax match asemeComment_282 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_280,asemeComment_282 skipwhite skipempty
syntax match asemeOperator_280 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_278 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_276,asemeComment_279 skipwhite skipempty
syntax region asemeComment_279 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_276,asemeComment_279 skipwhite skipempty
syntax match asemeComment_279 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_276,asemeComment_279 skipwhite skipempty
syntax match asemeName_276 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_274,asemeComment_277 skipwhite skipempty
syntax region asemeComment_277 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_274,asemeComment_277 skipwhite skipempty
syntax match asemeComment_277 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_274,asemeComment_277 skipwhite skipempty
syntax match asemePunctuation_274 /\v\:/ contained nextgroup=asemeBuiltIn_272,asemeType_273,asemeComment_275 skipwhite skipempty
syntax region asemeComment_275 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_272,asemeType_273,asemeComment_275 skipwhite skipempty
syntax match asemeComment_275 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_272,asemeType_273,asemeComment_275 skipwhite skipempty
syntax match asemeType_273 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeBuiltIn_272 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemePunctuation_232,asemeOperator_263,asemeName_268,asemeBuiltIn_270,asemeType_271
syntax match asemeType_271 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeBuiltIn_270 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeName_268 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_266,asemeComment_269 skipwhite skipempty
syntax region asemeComment_269 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_266,asemeComment_269 skipwhite skipempty
syntax match asemeComment_269 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_266,asemeComment_269 skipwhite skipempty
syntax match asemePunctuation_266 /\v\:/ contained nextgroup=asemeBuiltIn_264,asemeType_265,asemeComment_267 skipwhite skipempty
syntax region asemeComment_267 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_264,asemeType_265,asemeComment_267 skipwhite skipempty
syntax match asemeComment_267 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_264,asemeType_265,asemeComment_267 skipwhite skipempty
syntax match asemeType_265 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeBuiltIn_264 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeOperator_263 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemePunctuation_232 /\v\:/ contained nextgroup=asemeBuiltIn_229,asemeType_231,asemeComment_233 skipwhite skipempty
syntax region asemeComment_233 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_229,asemeType_231,asemeComment_233 skipwhite skipempty
syntax match asemeComment_233 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_229,asemeType_231,asemeComment_233 skipwhite skipempty
syntax match asemeType_231 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeBuiltIn_229 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax region asemeComment_230 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeComment_230 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_230 skipwhite skipempty
syntax match asemeDeclaration_227 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_226,asemeComment_228 skipwhite skipempty
syntax region asemeComment_228 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_226,asemeComment_228 skipwhite skipempty
syntax match asemeComment_228 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_226,asemeComment_228 skipwhite skipempty
syntax match asemeText_226 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_225 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax match asemePunctuation_223 /\v\.\./ contained nextgroup=asemeNumber_222,asemeComment_224 skipwhite skipempty
syntax region asemeComment_224 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_222,asemeComment_224 skipwhite skipempty
syntax match asemeComment_224 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_222,asemeComment_224 skipwhite skipempty
syntax match asemeNumber_222 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax match asemePunctuation_220 /\v\[/ contained nextgroup=asemeNumber_218,asemeComment_221 skipwhite skipempty
syntax region asemeComment_221 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_218,asemeComment_221 skipwhite skipempty
syntax match asemeComment_221 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_218,asemeComment_221 skipwhite skipempty
syntax match asemeNumber_218 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax region asemeComment_219 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax match asemeComment_219 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax match asemeDeclaration_216 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_217 skipwhite skipempty
syntax region asemeComment_217 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_217 skipwhite skipempty
syntax match asemeComment_217 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_217 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_215
syntax region asemePunctuation_215 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_195,asemeDeclaration_213,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_213 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_212,asemeComment_214 skipwhite skipempty
syntax region asemeComment_214 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_212,asemeComment_214 skipwhite skipempty
syntax match asemeComment_214 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_212,asemeComment_214 skipwhite skipempty
syntax match asemeName_212 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_199,asemeClause_202,asemeClause_205,asemePunctuation_208,asemeText_210,asemeName_211
syntax match asemeName_211 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemeText_210 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemePunctuation_208 /\v\,/ contained nextgroup=asemeReference_207,asemeComment_209 skipwhite skipempty
syntax region asemeComment_209 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_207,asemeComment_209 skipwhite skipempty
syntax match asemeComment_209 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_207,asemeComment_209 skipwhite skipempty
syntax match asemeReference_207 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemeClause_205 /\vrealises%(<|>)/ contained nextgroup=asemeReference_204,asemeComment_206 skipwhite skipempty
syntax region asemeComment_206 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_204,asemeComment_206 skipwhite skipempty
syntax match asemeComment_206 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_204,asemeComment_206 skipwhite skipempty
syntax match asemeReference_204 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemeClause_202 /\vincludes%(<|>)/ contained nextgroup=asemeReference_201,asemeComment_203 skipwhite skipempty
syntax region asemeComment_203 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_201,asemeComment_203 skipwhite skipempty
syntax match asemeComment_203 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_201,asemeComment_203 skipwhite skipempty
syntax match asemeReference_201 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemeClause_199 /\vby%(<|>)/ contained nextgroup=asemeReference_197,asemeComment_200 skipwhite skipempty
syntax region asemeComment_200 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_197,asemeComment_200 skipwhite skipempty
syntax match asemeComment_200 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_197,asemeComment_200 skipwhite skipempty
syntax match asemeReference_197 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax region asemeComment_198 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemeComment_198 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_198 skipwhite skipempty
syntax match asemeDeclaration_195 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_194,asemeComment_196 skipwhite skipempty
syntax region asemeComment_196 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_194,asemeComment_196 skipwhite skipempty
syntax match asemeComment_196 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_194,asemeComment_196 skipwhite skipempty
syntax match asemeReference_194 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_187 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemePunctuation_188,asemePunctuation_191,asemeReference_193
syntax match asemeReference_193 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_187 skipwhite skipempty
syntax match asemePunctuation_191 /\v\:/ contained nextgroup=asemeChoice_190,asemeComment_192 skipwhite skipempty
syntax region asemeComment_192 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_190,asemeComment_192 skipwhite skipempty
syntax match asemeComment_192 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_190,asemeComment_192 skipwhite skipempty
syntax match asemeChoice_190 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_187 skipwhite skipempty
syntax match asemePunctuation_188 /\v\,/ contained nextgroup=asemeReference_186,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_186,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_186,asemeComment_189 skipwhite skipempty
syntax match asemeReference_186 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_187 skipwhite skipempty
syntax region asemeComment_187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_187 skipwhite skipempty
syntax match asemeComment_187 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_187 skipwhite skipempty
syntax match asemeDeclaration_184 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_185 skipwhite skipempty
syntax region asemeComment_185 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_185 skipwhite skipempty
syntax match asemeComment_185 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_185 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_183
syntax region asemePunctuation_183 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_181,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_181 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_180,asemeComment_182 skipwhite skipempty
syntax region asemeComment_182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_180,asemeComment_182 skipwhite skipempty
syntax match asemeComment_182 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_180,asemeComment_182 skipwhite skipempty
syntax match asemeBlock_180 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_179 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_177,asemeBlock_178
syntax match asemeBlock_178 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_179 skipwhite skipempty
syntax region asemeComment_179 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_179 skipwhite skipempty
syntax match asemeComment_179 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_179 skipwhite skipempty
syntax region asemePunctuation_177 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_175,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_175 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax region asemeComment_176 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax match asemeComment_176 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax match asemeName_174 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_167,asemePunctuation_170,asemeText_172,asemeName_173
syntax match asemeName_173 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax match asemeText_172 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax match asemePunctuation_170 /\v\,/ contained nextgroup=asemeReference_169,asemeComment_171 skipwhite skipempty
syntax region asemeComment_171 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_169,asemeComment_171 skipwhite skipempty
syntax match asemeComment_171 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_169,asemeComment_171 skipwhite skipempty
syntax match asemeReference_169 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax match asemeClause_167 /\vdepends%(<|>)/ contained nextgroup=asemeClause_165,asemeComment_168 skipwhite skipempty
syntax region asemeComment_168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_165,asemeComment_168 skipwhite skipempty
syntax match asemeComment_168 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_165,asemeComment_168 skipwhite skipempty
syntax match asemeClause_165 /\von%(<|>)/ contained nextgroup=asemeReference_163,asemeComment_166 skipwhite skipempty
syntax region asemeComment_166 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_163,asemeComment_166 skipwhite skipempty
syntax match asemeComment_166 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_163,asemeComment_166 skipwhite skipempty
syntax match asemeReference_163 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax region asemeComment_164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax match asemeComment_164 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_164 skipwhite skipempty
syntax match asemeDeclaration_161 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_159,asemeComment_162 skipwhite skipempty
syntax region asemeComment_162 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_159,asemeComment_162 skipwhite skipempty
syntax match asemeComment_162 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_159,asemeComment_162 skipwhite skipempty
syntax match asemeName_159 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_158,asemeComment_160 skipwhite skipempty
syntax region asemeComment_160 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_158,asemeComment_160 skipwhite skipempty
syntax match asemeComment_160 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_158,asemeComment_160 skipwhite skipempty
syntax match asemePunctuation_158 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_142,asemePunctuation_148,asemePunctuation_150,asemeBuiltIn_152,asemeType_154,asemeName_156
syntax match asemeName_156 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_155,asemeComment_157 skipwhite skipempty
syntax region asemeComment_157 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_155,asemeComment_157 skipwhite skipempty
syntax match asemeComment_157 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_155,asemeComment_157 skipwhite skipempty
syntax match asemePunctuation_155 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax match asemeType_154 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_151,asemeComment_153 skipwhite skipempty
syntax match asemeBuiltIn_152 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_151,asemeComment_153 skipwhite skipempty
syntax region asemeComment_153 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_151,asemeComment_153 skipwhite skipempty
syntax match asemeComment_153 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_151,asemeComment_153 skipwhite skipempty
syntax match asemeName_151 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax match asemePunctuation_150 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax match asemePunctuation_148 /\v\,/ contained nextgroup=asemeBuiltIn_145,asemeType_147,asemeComment_149 skipwhite skipempty
syntax region asemeComment_149 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_145,asemeType_147,asemeComment_149 skipwhite skipempty
syntax match asemeComment_149 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_145,asemeType_147,asemeComment_149 skipwhite skipempty
syntax match asemeType_147 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax match asemeBuiltIn_145 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax region asemeComment_146 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax match asemeComment_146 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax match asemeName_144 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax match asemePunctuation_142 /\v\)/ contained nextgroup=asemePunctuation_140,asemeComment_143 skipwhite skipempty
syntax region asemeComment_143 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_140,asemeComment_143 skipwhite skipempty
syntax match asemeComment_143 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_140,asemeComment_143 skipwhite skipempty
syntax match asemePunctuation_140 /\v\:/ contained nextgroup=asemeBuiltIn_137,asemeType_139,asemeComment_141 skipwhite skipempty
syntax region asemeComment_141 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_137,asemeType_139,asemeComment_141 skipwhite skipempty
syntax match asemeComment_141 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_137,asemeType_139,asemeComment_141 skipwhite skipempty
syntax match asemeType_139 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_135,asemeComment_138 skipwhite skipempty
syntax match asemeBuiltIn_137 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_135,asemeComment_138 skipwhite skipempty
syntax region asemeComment_138 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_135,asemeComment_138 skipwhite skipempty
syntax match asemeComment_138 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_135,asemeComment_138 skipwhite skipempty
syntax match asemeOperator_135 /\v\=%(\=)@!/ contained nextgroup=asemeText_133,asemeComment_136 skipwhite skipempty
syntax region asemeComment_136 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_133,asemeComment_136 skipwhite skipempty
syntax match asemeComment_136 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_133,asemeComment_136 skipwhite skipempty
syntax match asemeText_133 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax region asemeComment_134 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax match asemeComment_134 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_134 skipwhite skipempty
syntax match asemeDeclaration_131 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_130,asemeComment_132 skipwhite skipempty
syntax region asemeComment_132 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_130,asemeComment_132 skipwhite skipempty
syntax match asemeComment_132 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_130,asemeComment_132 skipwhite skipempty
syntax match asemeBlock_130 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_107 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_108,asemeClause_111,asemePunctuation_128,asemeBlock_129
syntax match asemeBlock_129 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_107 skipwhite skipempty
syntax region asemePunctuation_128 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_126,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_126 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_125,asemeComment_127 skipwhite skipempty
syntax region asemeComment_127 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_125,asemeComment_127 skipwhite skipempty
syntax match asemeComment_127 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_125,asemeComment_127 skipwhite skipempty
syntax match asemeReference_125 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_115,asemeClause_118,asemeChoice_120,asemePunctuation_122,asemeReference_124
syntax match asemeReference_124 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax match asemePunctuation_122 /\v\,/ contained nextgroup=asemeReference_121,asemeComment_123 skipwhite skipempty
syntax region asemeComment_123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_121,asemeComment_123 skipwhite skipempty
syntax match asemeComment_123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_121,asemeComment_123 skipwhite skipempty
syntax match asemeReference_121 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax match asemeChoice_120 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax match asemeClause_118 /\vevery%(<|>)/ contained nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax region asemeComment_119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax match asemeComment_119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax match asemeNumber_117 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax match asemeClause_115 /\vfrom%(<|>)/ contained nextgroup=asemeReference_113,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_113,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_113,asemeComment_116 skipwhite skipempty
syntax match asemeReference_113 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax region asemeComment_114 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax match asemeComment_114 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_114 skipwhite skipempty
syntax match asemeClause_111 /\vradio%(<|>)/ contained nextgroup=asemeNumber_110,asemeComment_112 skipwhite skipempty
syntax region asemeComment_112 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_110,asemeComment_112 skipwhite skipempty
syntax match asemeComment_112 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_110,asemeComment_112 skipwhite skipempty
syntax match asemeNumber_110 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_107 skipwhite skipempty
syntax match asemeClause_108 /\vunder%(<|>)/ contained nextgroup=asemeReference_106,asemeComment_109 skipwhite skipempty
syntax region asemeComment_109 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_106,asemeComment_109 skipwhite skipempty
syntax match asemeComment_109 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_106,asemeComment_109 skipwhite skipempty
syntax match asemeReference_106 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_107 skipwhite skipempty
syntax region asemeComment_107 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_107 skipwhite skipempty
syntax match asemeComment_107 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_107 skipwhite skipempty
syntax match asemeDeclaration_104 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_103,asemeComment_105 skipwhite skipempty
syntax region asemeComment_105 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_103,asemeComment_105 skipwhite skipempty
syntax match asemeComment_105 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_103,asemeComment_105 skipwhite skipempty
syntax match asemeBlock_103 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_102 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_100,asemeBlock_101
syntax match asemeBlock_101 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_102 skipwhite skipempty
syntax region asemeComment_102 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_102 skipwhite skipempty
syntax match asemeComment_102 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_102 skipwhite skipempty
syntax region asemePunctuation_100 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_94,asemeBuiltIn_97,asemeType_99,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeType_99 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax match asemeBuiltIn_97 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax region asemeComment_98 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax match asemeComment_98 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax match asemeName_96 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax match asemeDeclaration_94 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_91,asemeType_93,asemeComment_95 skipwhite skipempty
syntax region asemeComment_95 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_91,asemeType_93,asemeComment_95 skipwhite skipempty
syntax match asemeComment_95 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_91,asemeType_93,asemeComment_95 skipwhite skipempty
syntax match asemeType_93 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_90,asemeComment_92 skipwhite skipempty
syntax match asemeBuiltIn_91 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_90,asemeComment_92 skipwhite skipempty
syntax region asemeComment_92 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_90,asemeComment_92 skipwhite skipempty
syntax match asemeComment_92 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_90,asemeComment_92 skipwhite skipempty
syntax match asemeName_90 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_82,asemePunctuation_84,asemeBuiltIn_86,asemeType_88,asemeName_89
syntax match asemeName_89 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax match asemeType_88 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_85,asemeComment_87 skipwhite skipempty
syntax match asemeBuiltIn_86 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_85,asemeComment_87 skipwhite skipempty
syntax region asemeComment_87 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_85,asemeComment_87 skipwhite skipempty
syntax match asemeComment_87 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_85,asemeComment_87 skipwhite skipempty
syntax match asemeName_85 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax match asemePunctuation_84 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax match asemeOperator_82 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_80,asemeComment_83 skipwhite skipempty
syntax region asemeComment_83 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_80,asemeComment_83 skipwhite skipempty
syntax match asemeComment_83 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_80,asemeComment_83 skipwhite skipempty
syntax match asemeNumber_80 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax region asemeComment_81 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax match asemeComment_81 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_81 skipwhite skipempty
syntax match asemeDeclaration_78 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_77,asemeComment_79 skipwhite skipempty
syntax region asemeComment_79 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_77,asemeComment_79 skipwhite skipempty
syntax match asemeComment_79 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_77,asemeComment_79 skipwhite skipempty
syntax match asemeBlock_77 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_76 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_74,asemeBlock_75
syntax match asemeBlock_75 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_76 skipwhite skipempty
syntax region asemeComment_76 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_76 skipwhite skipempty
syntax match asemeComment_76 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_76 skipwhite skipempty
syntax region asemePunctuation_74 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_73,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_73 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_69 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_70,asemePunctuation_72
syntax match asemePunctuation_72 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_69 skipwhite skipempty
syntax match asemeOperator_70 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_68,asemeComment_71 skipwhite skipempty
syntax region asemeComment_71 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_68,asemeComment_71 skipwhite skipempty
syntax match asemeComment_71 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_68,asemeComment_71 skipwhite skipempty
syntax match asemeNumber_68 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_69 skipwhite skipempty
syntax region asemeComment_69 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_69 skipwhite skipempty
syntax match asemeComment_69 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_69 skipwhite skipempty
syntax match asemeDeclaration_66 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_64,asemeComment_67 skipwhite skipempty
syntax region asemeComment_67 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_64,asemeComment_67 skipwhite skipempty
syntax match asemeComment_67 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_64,asemeComment_67 skipwhite skipempty
syntax match asemeName_64 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_63,asemeComment_65 skipwhite skipempty
syntax region asemeComment_65 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_63,asemeComment_65 skipwhite skipempty
syntax match asemeComment_65 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_63,asemeComment_65 skipwhite skipempty
syntax match asemeOperator_63 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_8 /\v%(import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=import%(<|>)/ nextgroup=asemeReference_6,asemeText_7,asemeComment_9 skipwhite skipempty
syntax region asemeComment_9 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_6,asemeText_7,asemeComment_9 skipwhite skipempty
syntax match asemeComment_9 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_6,asemeText_7,asemeComment_9 skipwhite skipempty
syntax match asemeText_7 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeReference_6 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained
syntax match asemeDeclaration_4 /\v%(system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=)@=system%(<|>)/ nextgroup=asemeName_3,asemeComment_5 skipwhite skipempty
syntax region asemeComment_5 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_3,asemeComment_5 skipwhite skipempty
syntax match asemeComment_5 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_3,asemeComment_5 skipwhite skipempty
syntax match asemeName_3 /\v%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))/ contained
syntax match asemeDeclaration_1 /\v%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=)@=language%(<|>)/ nextgroup=asemeNumber_0,asemeComment_2 skipwhite skipempty
syntax region asemeComment_2 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_0,asemeComment_2 skipwhite skipempty
syntax match asemeComment_2 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_0,asemeComment_2 skipwhite skipempty
syntax match asemeNumber_0 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_887,asemeClause_890,asemeText_892,asemeNumber_893,asemeTruth_894,asemeLogic_895,asemeClause_896,asemeClause_897,asemeClause_898,asemeClause_899,asemeClause_900,asemeClause_901,asemeClause_902,asemeClause_903,asemeClause_904,asemeClause_905,asemeCall_906,asemeReference_907,asemeOperator_908,asemePunctuation_909
syntax match asemePunctuation_909 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeOperator_908 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeReference_907 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeCall_906 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_905 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_904 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_903 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_902 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_901 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_900 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_899 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_898 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_897 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_896 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeLogic_895 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeTruth_894 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeNumber_893 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeText_892 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeClause_890 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_889,asemeComment_891 skipwhite skipempty
syntax region asemeComment_891 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_889,asemeComment_891 skipwhite skipempty
syntax match asemeComment_891 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_889,asemeComment_891 skipwhite skipempty
syntax match asemeReference_889 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_882,asemeComment_884 skipwhite skipempty
syntax match asemeClause_887 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_885,asemeComment_888 skipwhite skipempty
syntax region asemeComment_888 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_885,asemeComment_888 skipwhite skipempty
syntax match asemeComment_888 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_885,asemeComment_888 skipwhite skipempty
syntax match asemeReference_885 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_883,asemeComment_886 skipwhite skipempty
syntax region asemeComment_886 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_883,asemeComment_886 skipwhite skipempty
syntax match asemeComment_886 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_883,asemeComment_886 skipwhite skipempty
syntax match asemeReference_883 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_882,asemeComment_884 skipwhite skipempty
syntax region asemeComment_884 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_882,asemeComment_884 skipwhite skipempty
syntax match asemeComment_884 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_882,asemeComment_884 skipwhite skipempty
syntax region asemePunctuation_882 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax region asemeComment_881 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax match asemeComment_881 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_881 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_826,asemeClause_829,asemeText_831,asemeNumber_832,asemeTruth_833,asemeLogic_834,asemeClause_835,asemeClause_836,asemeClause_837,asemeClause_838,asemeClause_839,asemeClause_840,asemeClause_841,asemeClause_842,asemeClause_843,asemeClause_844,asemeCall_845,asemeReference_846,asemeOperator_847,asemePunctuation_848
syntax match asemePunctuation_848 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeOperator_847 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeReference_846 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeCall_845 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_844 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_843 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_842 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_841 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_840 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_839 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_838 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_837 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_836 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_835 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeLogic_834 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeTruth_833 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeNumber_832 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeText_831 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeClause_829 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_828,asemeComment_830 skipwhite skipempty
syntax region asemeComment_830 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_828,asemeComment_830 skipwhite skipempty
syntax match asemeComment_830 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_828,asemeComment_830 skipwhite skipempty
syntax match asemeReference_828 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_821,asemeComment_823 skipwhite skipempty
syntax match asemeClause_826 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_824,asemeComment_827 skipwhite skipempty
syntax region asemeComment_827 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_824,asemeComment_827 skipwhite skipempty
syntax match asemeComment_827 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_824,asemeComment_827 skipwhite skipempty
syntax match asemeReference_824 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_822,asemeComment_825 skipwhite skipempty
syntax region asemeComment_825 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_822,asemeComment_825 skipwhite skipempty
syntax match asemeComment_825 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_822,asemeComment_825 skipwhite skipempty
syntax match asemeReference_822 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_821,asemeComment_823 skipwhite skipempty
syntax region asemeComment_823 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_821,asemeComment_823 skipwhite skipempty
syntax match asemeComment_823 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_821,asemeComment_823 skipwhite skipempty
syntax region asemePunctuation_821 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax region asemeComment_820 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax match asemeComment_820 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_820 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_787,asemeClause_790,asemeText_792,asemeNumber_793,asemeTruth_794,asemeLogic_795,asemeClause_796,asemeClause_797,asemeClause_798,asemeClause_799,asemeClause_800,asemeClause_801,asemeClause_802,asemeClause_803,asemeClause_804,asemeClause_805,asemeCall_806,asemeReference_807,asemeOperator_808,asemePunctuation_809
syntax match asemePunctuation_809 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeOperator_808 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeReference_807 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeCall_806 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_805 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_804 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_803 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_802 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_801 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_800 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_799 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_798 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_797 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_796 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeLogic_795 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeTruth_794 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeNumber_793 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeText_792 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeClause_790 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_789,asemeComment_791 skipwhite skipempty
syntax region asemeComment_791 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_789,asemeComment_791 skipwhite skipempty
syntax match asemeComment_791 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_789,asemeComment_791 skipwhite skipempty
syntax match asemeReference_789 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax match asemeClause_787 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_785,asemeComment_788 skipwhite skipempty
syntax region asemeComment_788 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_785,asemeComment_788 skipwhite skipempty
syntax match asemeComment_788 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_785,asemeComment_788 skipwhite skipempty
syntax match asemeReference_785 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_783,asemeComment_786 skipwhite skipempty
syntax region asemeComment_786 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_783,asemeComment_786 skipwhite skipempty
syntax match asemeComment_786 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_783,asemeComment_786 skipwhite skipempty
syntax match asemeReference_783 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax region asemeComment_784 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax match asemeComment_784 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax region asemePunctuation_782 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax region asemeComment_781 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax match asemeComment_781 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_781 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_603,asemeNumber_605,asemeReference_606,asemeNumber_607,asemeOperator_608,asemePunctuation_609
syntax match asemePunctuation_609 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemeOperator_608 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemeNumber_607 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemeReference_606 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemeNumber_605 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemeText_603 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_604 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_546,asemeClause_549,asemeText_551,asemeNumber_552,asemeTruth_553,asemeLogic_554,asemeClause_555,asemeClause_556,asemeClause_557,asemeClause_558,asemeClause_559,asemeClause_560,asemeClause_561,asemeClause_562,asemeClause_563,asemeClause_564,asemeCall_565,asemeReference_566,asemeOperator_567,asemePunctuation_568
syntax match asemePunctuation_568 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeOperator_567 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeReference_566 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeCall_565 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_564 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_563 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_562 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_561 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_560 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_559 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_558 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_557 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_556 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_555 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeLogic_554 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeTruth_553 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeNumber_552 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeText_551 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeClause_549 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_548,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_548,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_548,asemeComment_550 skipwhite skipempty
syntax match asemeReference_548 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_541,asemeComment_543 skipwhite skipempty
syntax match asemeClause_546 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_544,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_544,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_544,asemeComment_547 skipwhite skipempty
syntax match asemeReference_544 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_542,asemeComment_545 skipwhite skipempty
syntax region asemeComment_545 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_542,asemeComment_545 skipwhite skipempty
syntax match asemeComment_545 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_542,asemeComment_545 skipwhite skipempty
syntax match asemeReference_542 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_541,asemeComment_543 skipwhite skipempty
syntax region asemeComment_543 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_541,asemeComment_543 skipwhite skipempty
syntax match asemeComment_543 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_541,asemeComment_543 skipwhite skipempty
syntax region asemePunctuation_541 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax region asemeComment_540 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax match asemeComment_540 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_540 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_424,asemeClause_427,asemeText_429,asemeNumber_430,asemeTruth_431,asemeLogic_432,asemeClause_433,asemeClause_434,asemeClause_435,asemeClause_436,asemeClause_437,asemeClause_438,asemeClause_439,asemeClause_440,asemeClause_441,asemeClause_442,asemeCall_443,asemeReference_444,asemeOperator_445,asemePunctuation_446
syntax match asemePunctuation_446 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeOperator_445 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeReference_444 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeCall_443 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_442 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_441 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_440 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_439 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_438 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_437 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_436 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_435 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_434 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_433 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeLogic_432 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeTruth_431 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeNumber_430 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeText_429 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_427 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_426,asemeComment_428 skipwhite skipempty
syntax region asemeComment_428 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_426,asemeComment_428 skipwhite skipempty
syntax match asemeComment_428 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_426,asemeComment_428 skipwhite skipempty
syntax match asemeReference_426 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_419,asemeComment_421 skipwhite skipempty
syntax match asemeClause_424 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_422,asemeComment_425 skipwhite skipempty
syntax region asemeComment_425 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_422,asemeComment_425 skipwhite skipempty
syntax match asemeComment_425 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_422,asemeComment_425 skipwhite skipempty
syntax match asemeReference_422 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_420,asemeComment_423 skipwhite skipempty
syntax region asemeComment_423 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_420,asemeComment_423 skipwhite skipempty
syntax match asemeComment_423 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_420,asemeComment_423 skipwhite skipempty
syntax match asemeReference_420 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_419,asemeComment_421 skipwhite skipempty
syntax region asemeComment_421 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_419,asemeComment_421 skipwhite skipempty
syntax match asemeComment_421 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_419,asemeComment_421 skipwhite skipempty
syntax region asemePunctuation_419 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax region asemeComment_418 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeComment_418 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_387,asemeClause_390,asemeText_392,asemeNumber_393,asemeTruth_394,asemeLogic_395,asemeClause_396,asemeClause_397,asemeClause_398,asemeClause_399,asemeClause_400,asemeClause_401,asemeClause_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeCall_406,asemeReference_407,asemeOperator_408,asemePunctuation_409
syntax match asemePunctuation_409 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeOperator_408 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeReference_407 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeCall_406 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_402 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_401 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_400 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_399 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_398 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_397 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_396 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeLogic_395 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeTruth_394 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeNumber_393 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeText_392 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_390 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_389,asemeComment_391 skipwhite skipempty
syntax region asemeComment_391 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_389,asemeComment_391 skipwhite skipempty
syntax match asemeComment_391 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_389,asemeComment_391 skipwhite skipempty
syntax match asemeReference_389 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_382,asemeComment_384 skipwhite skipempty
syntax match asemeClause_387 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_385,asemeComment_388 skipwhite skipempty
syntax region asemeComment_388 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_385,asemeComment_388 skipwhite skipempty
syntax match asemeComment_388 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_385,asemeComment_388 skipwhite skipempty
syntax match asemeReference_385 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_383,asemeComment_386 skipwhite skipempty
syntax region asemeComment_386 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_383,asemeComment_386 skipwhite skipempty
syntax match asemeComment_386 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_383,asemeComment_386 skipwhite skipempty
syntax match asemeReference_383 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_382,asemeComment_384 skipwhite skipempty
syntax region asemeComment_384 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_382,asemeComment_384 skipwhite skipempty
syntax match asemeComment_384 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_382,asemeComment_384 skipwhite skipempty
syntax region asemePunctuation_382 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax region asemeComment_381 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeComment_381 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_325,asemeNumber_327,asemeReference_328,asemeNumber_329,asemeOperator_330,asemePunctuation_331
syntax match asemePunctuation_331 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemeOperator_330 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemeNumber_329 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemeReference_328 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemeNumber_327 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemeText_325 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax region asemeComment_326 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax match asemeComment_326 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_326 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_240,asemeClause_243,asemeText_245,asemeNumber_246,asemeTruth_247,asemeLogic_248,asemeClause_249,asemeClause_250,asemeClause_251,asemeClause_252,asemeClause_253,asemeClause_254,asemeClause_255,asemeClause_256,asemeClause_257,asemeClause_258,asemeCall_259,asemeReference_260,asemeOperator_261,asemePunctuation_262
syntax match asemePunctuation_262 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeOperator_261 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeReference_260 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeCall_259 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_258 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_257 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_256 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_255 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_254 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_253 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_252 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_251 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_250 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_249 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeLogic_248 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeTruth_247 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeNumber_246 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeText_245 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeClause_243 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_242,asemeComment_244 skipwhite skipempty
syntax region asemeComment_244 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_242,asemeComment_244 skipwhite skipempty
syntax match asemeComment_244 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_242,asemeComment_244 skipwhite skipempty
syntax match asemeReference_242 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_235,asemeComment_237 skipwhite skipempty
syntax match asemeClause_240 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_238,asemeComment_241 skipwhite skipempty
syntax region asemeComment_241 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_238,asemeComment_241 skipwhite skipempty
syntax match asemeComment_241 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_238,asemeComment_241 skipwhite skipempty
syntax match asemeReference_238 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_236,asemeComment_239 skipwhite skipempty
syntax region asemeComment_239 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_236,asemeComment_239 skipwhite skipempty
syntax match asemeComment_239 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_236,asemeComment_239 skipwhite skipempty
syntax match asemeReference_236 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_235,asemeComment_237 skipwhite skipempty
syntax region asemeComment_237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_235,asemeComment_237 skipwhite skipempty
syntax match asemeComment_237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_235,asemeComment_237 skipwhite skipempty
syntax region asemePunctuation_235 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax region asemeComment_234 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeComment_234 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_40,asemeClause_43,asemeText_45,asemeNumber_46,asemeTruth_47,asemeLogic_48,asemeClause_49,asemeClause_50,asemeClause_51,asemeClause_52,asemeClause_53,asemeClause_54,asemeClause_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeCall_59,asemeReference_60,asemeOperator_61,asemePunctuation_62
syntax match asemePunctuation_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeOperator_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeReference_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeCall_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_51 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_50 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_49 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeLogic_48 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeTruth_47 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeNumber_46 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeText_45 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_43 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_42,asemeComment_44 skipwhite skipempty
syntax region asemeComment_44 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_42,asemeComment_44 skipwhite skipempty
syntax match asemeComment_44 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_42,asemeComment_44 skipwhite skipempty
syntax match asemeReference_42 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_35,asemeComment_37 skipwhite skipempty
syntax match asemeClause_40 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_38,asemeComment_41 skipwhite skipempty
syntax region asemeComment_41 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_38,asemeComment_41 skipwhite skipempty
syntax match asemeComment_41 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_38,asemeComment_41 skipwhite skipempty
syntax match asemeReference_38 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_36,asemeComment_39 skipwhite skipempty
syntax region asemeComment_39 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_36,asemeComment_39 skipwhite skipempty
syntax match asemeComment_39 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_36,asemeComment_39 skipwhite skipempty
syntax match asemeReference_36 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_35,asemeComment_37 skipwhite skipempty
syntax region asemeComment_37 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_35,asemeComment_37 skipwhite skipempty
syntax match asemeComment_37 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_35,asemeComment_37 skipwhite skipempty
syntax region asemePunctuation_35 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax region asemeComment_34 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeComment_34 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax cluster asemeContentOfAMessage contains=asemeText_10,asemeNumber_11,asemeTruth_12,asemeLogic_13,asemeClause_14,asemeClause_15,asemeClause_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeClause_23,asemeCall_24,asemeReference_25,asemeOperator_26,asemePunctuation_27,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_27 /\v%([^ \t{}])@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_26 /\v%([^ \t{}])@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_25 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeCall_24 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained
syntax match asemeClause_23 /\v%([^ \t{}])@=write_messages%(<|>)%(\_s*\.)@=/ contained
syntax match asemeClause_22 /\v%([^ \t{}])@=read_messages%(<|>)%(\_s*\()@!/ contained
syntax match asemeClause_21 /\v%([^ \t{}])@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_20 /\v%([^ \t{}])@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_19 /\v%([^ \t{}])@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_18 /\v%([^ \t{}])@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_17 /\v%([^ \t{}])@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_16 /\v%([^ \t{}])@=after%(<|>)%(\_s*\()@=/ contained
syntax match asemeClause_15 /\v%([^ \t{}])@=when%(<|>)/ contained
syntax match asemeClause_14 /\v%([^ \t{}])@=else%(<|>)/ contained
syntax match asemeLogic_13 /\v%([^ \t{}])@=%(and|or|not)%(<|>)/ contained
syntax match asemeTruth_12 /\v%([^ \t{}])@=%(true|false)%(<|>)%(\_s*\.)@!/ contained
syntax match asemeNumber_11 /\v%([^ \t{}])@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_10 /\v%([^ \t{}])@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemeComment start=/\v\/\*/ end=/\v\*\// contains=@Spell
syntax match asemeComment /\v\/\/.*$/ contains=@Spell
highlight default link asemeBlock_101 asemeBlock
highlight default link asemeBlock_103 asemeBlock
highlight default link asemeBlock_129 asemeBlock
highlight default link asemeBlock_130 asemeBlock
highlight default link asemeBlock_178 asemeBlock
highlight default link asemeBlock_180 asemeBlock
highlight default link asemeBlock_335 asemeBlock
highlight default link asemeBlock_336 asemeBlock
highlight default link asemeBlock_458 asemeBlock
highlight default link asemeBlock_461 asemeBlock
highlight default link asemeBlock_466 asemeBlock
highlight default link asemeBlock_468 asemeBlock
highlight default link asemeBlock_471 asemeBlock
highlight default link asemeBlock_725 asemeBlock
highlight default link asemeBlock_727 asemeBlock
highlight default link asemeBlock_733 asemeBlock
highlight default link asemeBlock_736 asemeBlock
highlight default link asemeBlock_741 asemeBlock
highlight default link asemeBlock_742 asemeBlock
highlight default link asemeBlock_747 asemeBlock
highlight default link asemeBlock_75 asemeBlock
highlight default link asemeBlock_77 asemeBlock
highlight default link asemeBlock_876 asemeBlock
highlight default link asemeBlock_878 asemeBlock
highlight default link asemeBlock_936 asemeBlock
highlight default link asemeBlock_938 asemeBlock
highlight default link asemeBuiltIn_137 asemeBuiltIn
highlight default link asemeBuiltIn_145 asemeBuiltIn
highlight default link asemeBuiltIn_152 asemeBuiltIn
highlight default link asemeBuiltIn_229 asemeBuiltIn
highlight default link asemeBuiltIn_264 asemeBuiltIn
highlight default link asemeBuiltIn_270 asemeBuiltIn
highlight default link asemeBuiltIn_272 asemeBuiltIn
highlight default link asemeBuiltIn_317 asemeBuiltIn
highlight default link asemeBuiltIn_535 asemeBuiltIn
highlight default link asemeBuiltIn_570 asemeBuiltIn
highlight default link asemeBuiltIn_576 asemeBuiltIn
highlight default link asemeBuiltIn_578 asemeBuiltIn
highlight default link asemeBuiltIn_595 asemeBuiltIn
highlight default link asemeBuiltIn_647 asemeBuiltIn
highlight default link asemeBuiltIn_655 asemeBuiltIn
highlight default link asemeBuiltIn_815 asemeBuiltIn
highlight default link asemeBuiltIn_850 asemeBuiltIn
highlight default link asemeBuiltIn_856 asemeBuiltIn
highlight default link asemeBuiltIn_858 asemeBuiltIn
highlight default link asemeBuiltIn_86 asemeBuiltIn
highlight default link asemeBuiltIn_91 asemeBuiltIn
highlight default link asemeBuiltIn_97 asemeBuiltIn
highlight default link asemeCall_24 asemeCall
highlight default link asemeCall_259 asemeCall
highlight default link asemeCall_406 asemeCall
highlight default link asemeCall_443 asemeCall
highlight default link asemeCall_565 asemeCall
highlight default link asemeCall_59 asemeCall
highlight default link asemeCall_806 asemeCall
highlight default link asemeCall_845 asemeCall
highlight default link asemeCall_906 asemeCall
highlight default link asemeChoice_120 asemeChoice
highlight default link asemeChoice_190 asemeChoice
highlight default link asemeChoice_342 asemeChoice
highlight default link asemeChoice_617 asemeChoice
highlight default link asemeChoice_631 asemeChoice
highlight default link asemeChoice_662 asemeChoice
highlight default link asemeChoice_676 asemeChoice
highlight default link asemeChoice_690 asemeChoice
highlight default link asemeChoice_707 asemeChoice
highlight default link asemeChoice_756 asemeChoice
highlight default link asemeChoice_760 asemeChoice
highlight default link asemeChoice_768 asemeChoice
highlight default link asemeClause_108 asemeClause
highlight default link asemeClause_111 asemeClause
highlight default link asemeClause_115 asemeClause
highlight default link asemeClause_118 asemeClause
highlight default link asemeClause_14 asemeClause
highlight default link asemeClause_15 asemeClause
highlight default link asemeClause_16 asemeClause
highlight default link asemeClause_165 asemeClause
highlight default link asemeClause_167 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_199 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_202 asemeClause
highlight default link asemeClause_205 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_240 asemeClause
highlight default link asemeClause_243 asemeClause
highlight default link asemeClause_249 asemeClause
highlight default link asemeClause_250 asemeClause
highlight default link asemeClause_251 asemeClause
highlight default link asemeClause_252 asemeClause
highlight default link asemeClause_253 asemeClause
highlight default link asemeClause_254 asemeClause
highlight default link asemeClause_255 asemeClause
highlight default link asemeClause_256 asemeClause
highlight default link asemeClause_257 asemeClause
highlight default link asemeClause_258 asemeClause
highlight default link asemeClause_345 asemeClause
highlight default link asemeClause_347 asemeClause
highlight default link asemeClause_350 asemeClause
highlight default link asemeClause_352 asemeClause
highlight default link asemeClause_353 asemeClause
highlight default link asemeClause_356 asemeClause
highlight default link asemeClause_358 asemeClause
highlight default link asemeClause_359 asemeClause
highlight default link asemeClause_376 asemeClause
highlight default link asemeClause_387 asemeClause
highlight default link asemeClause_390 asemeClause
highlight default link asemeClause_396 asemeClause
highlight default link asemeClause_397 asemeClause
highlight default link asemeClause_398 asemeClause
highlight default link asemeClause_399 asemeClause
highlight default link asemeClause_40 asemeClause
highlight default link asemeClause_400 asemeClause
highlight default link asemeClause_401 asemeClause
highlight default link asemeClause_402 asemeClause
highlight default link asemeClause_403 asemeClause
highlight default link asemeClause_404 asemeClause
highlight default link asemeClause_405 asemeClause
highlight default link asemeClause_424 asemeClause
highlight default link asemeClause_427 asemeClause
highlight default link asemeClause_43 asemeClause
highlight default link asemeClause_433 asemeClause
highlight default link asemeClause_434 asemeClause
highlight default link asemeClause_435 asemeClause
highlight default link asemeClause_436 asemeClause
highlight default link asemeClause_437 asemeClause
highlight default link asemeClause_438 asemeClause
highlight default link asemeClause_439 asemeClause
highlight default link asemeClause_440 asemeClause
highlight default link asemeClause_441 asemeClause
highlight default link asemeClause_442 asemeClause
highlight default link asemeClause_473 asemeClause
highlight default link asemeClause_489 asemeClause
highlight default link asemeClause_49 asemeClause
highlight default link asemeClause_492 asemeClause
highlight default link asemeClause_50 asemeClause
highlight default link asemeClause_51 asemeClause
highlight default link asemeClause_52 asemeClause
highlight default link asemeClause_53 asemeClause
highlight default link asemeClause_54 asemeClause
highlight default link asemeClause_546 asemeClause
highlight default link asemeClause_549 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_555 asemeClause
highlight default link asemeClause_556 asemeClause
highlight default link asemeClause_557 asemeClause
highlight default link asemeClause_558 asemeClause
highlight default link asemeClause_559 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_560 asemeClause
highlight default link asemeClause_561 asemeClause
highlight default link asemeClause_562 asemeClause
highlight default link asemeClause_563 asemeClause
highlight default link asemeClause_564 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_620 asemeClause
highlight default link asemeClause_623 asemeClause
highlight default link asemeClause_626 asemeClause
highlight default link asemeClause_629 asemeClause
highlight default link asemeClause_632 asemeClause
highlight default link asemeClause_635 asemeClause
highlight default link asemeClause_638 asemeClause
highlight default link asemeClause_641 asemeClause
highlight default link asemeClause_644 asemeClause
highlight default link asemeClause_646 asemeClause
highlight default link asemeClause_679 asemeClause
highlight default link asemeClause_682 asemeClause
highlight default link asemeClause_685 asemeClause
highlight default link asemeClause_688 asemeClause
highlight default link asemeClause_691 asemeClause
highlight default link asemeClause_694 asemeClause
highlight default link asemeClause_697 asemeClause
highlight default link asemeClause_700 asemeClause
highlight default link asemeClause_703 asemeClause
highlight default link asemeClause_705 asemeClause
highlight default link asemeClause_743 asemeClause
highlight default link asemeClause_752 asemeClause
highlight default link asemeClause_787 asemeClause
highlight default link asemeClause_790 asemeClause
highlight default link asemeClause_796 asemeClause
highlight default link asemeClause_797 asemeClause
highlight default link asemeClause_798 asemeClause
highlight default link asemeClause_799 asemeClause
highlight default link asemeClause_800 asemeClause
highlight default link asemeClause_801 asemeClause
highlight default link asemeClause_802 asemeClause
highlight default link asemeClause_803 asemeClause
highlight default link asemeClause_804 asemeClause
highlight default link asemeClause_805 asemeClause
highlight default link asemeClause_826 asemeClause
highlight default link asemeClause_829 asemeClause
highlight default link asemeClause_835 asemeClause
highlight default link asemeClause_836 asemeClause
highlight default link asemeClause_837 asemeClause
highlight default link asemeClause_838 asemeClause
highlight default link asemeClause_839 asemeClause
highlight default link asemeClause_840 asemeClause
highlight default link asemeClause_841 asemeClause
highlight default link asemeClause_842 asemeClause
highlight default link asemeClause_843 asemeClause
highlight default link asemeClause_844 asemeClause
highlight default link asemeClause_887 asemeClause
highlight default link asemeClause_890 asemeClause
highlight default link asemeClause_896 asemeClause
highlight default link asemeClause_897 asemeClause
highlight default link asemeClause_898 asemeClause
highlight default link asemeClause_899 asemeClause
highlight default link asemeClause_900 asemeClause
highlight default link asemeClause_901 asemeClause
highlight default link asemeClause_902 asemeClause
highlight default link asemeClause_903 asemeClause
highlight default link asemeClause_904 asemeClause
highlight default link asemeClause_905 asemeClause
highlight default link asemeClause_913 asemeClause
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_105 asemeComment
highlight default link asemeComment_107 asemeComment
highlight default link asemeComment_109 asemeComment
highlight default link asemeComment_112 asemeComment
highlight default link asemeComment_114 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_119 asemeComment
highlight default link asemeComment_123 asemeComment
highlight default link asemeComment_127 asemeComment
highlight default link asemeComment_132 asemeComment
highlight default link asemeComment_134 asemeComment
highlight default link asemeComment_136 asemeComment
highlight default link asemeComment_138 asemeComment
highlight default link asemeComment_141 asemeComment
highlight default link asemeComment_143 asemeComment
highlight default link asemeComment_146 asemeComment
highlight default link asemeComment_149 asemeComment
highlight default link asemeComment_153 asemeComment
highlight default link asemeComment_157 asemeComment
highlight default link asemeComment_160 asemeComment
highlight default link asemeComment_162 asemeComment
highlight default link asemeComment_164 asemeComment
highlight default link asemeComment_166 asemeComment
highlight default link asemeComment_168 asemeComment
highlight default link asemeComment_171 asemeComment
highlight default link asemeComment_176 asemeComment
highlight default link asemeComment_179 asemeComment
highlight default link asemeComment_182 asemeComment
highlight default link asemeComment_185 asemeComment
highlight default link asemeComment_187 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_192 asemeComment
highlight default link asemeComment_196 asemeComment
highlight default link asemeComment_198 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_200 asemeComment
highlight default link asemeComment_203 asemeComment
highlight default link asemeComment_206 asemeComment
highlight default link asemeComment_209 asemeComment
highlight default link asemeComment_214 asemeComment
highlight default link asemeComment_217 asemeComment
highlight default link asemeComment_219 asemeComment
highlight default link asemeComment_221 asemeComment
highlight default link asemeComment_224 asemeComment
highlight default link asemeComment_228 asemeComment
highlight default link asemeComment_230 asemeComment
highlight default link asemeComment_233 asemeComment
highlight default link asemeComment_234 asemeComment
highlight default link asemeComment_237 asemeComment
highlight default link asemeComment_239 asemeComment
highlight default link asemeComment_241 asemeComment
highlight default link asemeComment_244 asemeComment
highlight default link asemeComment_267 asemeComment
highlight default link asemeComment_269 asemeComment
highlight default link asemeComment_275 asemeComment
highlight default link asemeComment_277 asemeComment
highlight default link asemeComment_279 asemeComment
highlight default link asemeComment_282 asemeComment
highlight default link asemeComment_284 asemeComment
highlight default link asemeComment_286 asemeComment
highlight default link asemeComment_288 asemeComment
highlight default link asemeComment_290 asemeComment
highlight default link asemeComment_293 asemeComment
highlight default link asemeComment_296 asemeComment
highlight default link asemeComment_298 asemeComment
highlight default link asemeComment_300 asemeComment
highlight default link asemeComment_302 asemeComment
highlight default link asemeComment_304 asemeComment
highlight default link asemeComment_307 asemeComment
highlight default link asemeComment_310 asemeComment
highlight default link asemeComment_312 asemeComment
highlight default link asemeComment_314 asemeComment
highlight default link asemeComment_316 asemeComment
highlight default link asemeComment_320 asemeComment
highlight default link asemeComment_323 asemeComment
highlight default link asemeComment_326 asemeComment
highlight default link asemeComment_338 asemeComment
highlight default link asemeComment_34 asemeComment
highlight default link asemeComment_341 asemeComment
highlight default link asemeComment_343 asemeComment
highlight default link asemeComment_346 asemeComment
highlight default link asemeComment_348 asemeComment
highlight default link asemeComment_351 asemeComment
highlight default link asemeComment_354 asemeComment
highlight default link asemeComment_357 asemeComment
highlight default link asemeComment_362 asemeComment
highlight default link asemeComment_365 asemeComment
highlight default link asemeComment_37 asemeComment
highlight default link asemeComment_371 asemeComment
highlight default link asemeComment_373 asemeComment
highlight default link asemeComment_375 asemeComment
highlight default link asemeComment_377 asemeComment
highlight default link asemeComment_380 asemeComment
highlight default link asemeComment_381 asemeComment
highlight default link asemeComment_384 asemeComment
highlight default link asemeComment_386 asemeComment
highlight default link asemeComment_388 asemeComment
highlight default link asemeComment_39 asemeComment
highlight default link asemeComment_391 asemeComment
highlight default link asemeComment_41 asemeComment
highlight default link asemeComment_418 asemeComment
highlight default link asemeComment_421 asemeComment
highlight default link asemeComment_423 asemeComment
highlight default link asemeComment_425 asemeComment
highlight default link asemeComment_428 asemeComment
highlight default link asemeComment_44 asemeComment
highlight default link asemeComment_449 asemeComment
highlight default link asemeComment_451 asemeComment
highlight default link asemeComment_453 asemeComment
highlight default link asemeComment_456 asemeComment
highlight default link asemeComment_459 asemeComment
highlight default link asemeComment_462 asemeComment
highlight default link asemeComment_464 asemeComment
highlight default link asemeComment_467 asemeComment
highlight default link asemeComment_470 asemeComment
highlight default link asemeComment_472 asemeComment
highlight default link asemeComment_474 asemeComment
highlight default link asemeComment_476 asemeComment
highlight default link asemeComment_478 asemeComment
highlight default link asemeComment_482 asemeComment
highlight default link asemeComment_484 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_488 asemeComment
highlight default link asemeComment_490 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_496 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_501 asemeComment
highlight default link asemeComment_503 asemeComment
highlight default link asemeComment_506 asemeComment
highlight default link asemeComment_509 asemeComment
highlight default link asemeComment_511 asemeComment
highlight default link asemeComment_514 asemeComment
highlight default link asemeComment_516 asemeComment
highlight default link asemeComment_518 asemeComment
highlight default link asemeComment_520 asemeComment
highlight default link asemeComment_522 asemeComment
highlight default link asemeComment_525 asemeComment
highlight default link asemeComment_529 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_534 asemeComment
highlight default link asemeComment_536 asemeComment
highlight default link asemeComment_539 asemeComment
highlight default link asemeComment_540 asemeComment
highlight default link asemeComment_543 asemeComment
highlight default link asemeComment_545 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_550 asemeComment
highlight default link asemeComment_573 asemeComment
highlight default link asemeComment_575 asemeComment
highlight default link asemeComment_581 asemeComment
highlight default link asemeComment_583 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_588 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_594 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_614 asemeComment
highlight default link asemeComment_616 asemeComment
highlight default link asemeComment_618 asemeComment
highlight default link asemeComment_621 asemeComment
highlight default link asemeComment_624 asemeComment
highlight default link asemeComment_627 asemeComment
highlight default link asemeComment_630 asemeComment
highlight default link asemeComment_633 asemeComment
highlight default link asemeComment_636 asemeComment
highlight default link asemeComment_639 asemeComment
highlight default link asemeComment_642 asemeComment
highlight default link asemeComment_645 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_650 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_654 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_660 asemeComment
highlight default link asemeComment_663 asemeComment
highlight default link asemeComment_668 asemeComment
highlight default link asemeComment_67 asemeComment
highlight default link asemeComment_673 asemeComment
highlight default link asemeComment_675 asemeComment
highlight default link asemeComment_677 asemeComment
highlight default link asemeComment_680 asemeComment
highlight default link asemeComment_683 asemeComment
highlight default link asemeComment_686 asemeComment
highlight default link asemeComment_689 asemeComment
highlight default link asemeComment_69 asemeComment
highlight default link asemeComment_692 asemeComment
highlight default link asemeComment_695 asemeComment
highlight default link asemeComment_698 asemeComment
highlight default link asemeComment_701 asemeComment
highlight default link asemeComment_704 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_71 asemeComment
highlight default link asemeComment_713 asemeComment
highlight default link asemeComment_716 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_723 asemeComment
highlight default link asemeComment_726 asemeComment
highlight default link asemeComment_729 asemeComment
highlight default link asemeComment_731 asemeComment
highlight default link asemeComment_734 asemeComment
highlight default link asemeComment_737 asemeComment
highlight default link asemeComment_739 asemeComment
highlight default link asemeComment_744 asemeComment
highlight default link asemeComment_746 asemeComment
highlight default link asemeComment_749 asemeComment
highlight default link asemeComment_751 asemeComment
highlight default link asemeComment_753 asemeComment
highlight default link asemeComment_757 asemeComment
highlight default link asemeComment_76 asemeComment
highlight default link asemeComment_761 asemeComment
highlight default link asemeComment_763 asemeComment
highlight default link asemeComment_769 asemeComment
highlight default link asemeComment_771 asemeComment
highlight default link asemeComment_773 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_778 asemeComment
highlight default link asemeComment_780 asemeComment
highlight default link asemeComment_781 asemeComment
highlight default link asemeComment_784 asemeComment
highlight default link asemeComment_786 asemeComment
highlight default link asemeComment_788 asemeComment
highlight default link asemeComment_79 asemeComment
highlight default link asemeComment_791 asemeComment
highlight default link asemeComment_81 asemeComment
highlight default link asemeComment_812 asemeComment
highlight default link asemeComment_814 asemeComment
highlight default link asemeComment_816 asemeComment
highlight default link asemeComment_819 asemeComment
highlight default link asemeComment_820 asemeComment
highlight default link asemeComment_823 asemeComment
highlight default link asemeComment_825 asemeComment
highlight default link asemeComment_827 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_830 asemeComment
highlight default link asemeComment_853 asemeComment
highlight default link asemeComment_855 asemeComment
highlight default link asemeComment_861 asemeComment
highlight default link asemeComment_863 asemeComment
highlight default link asemeComment_865 asemeComment
highlight default link asemeComment_868 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_870 asemeComment
highlight default link asemeComment_872 asemeComment
highlight default link asemeComment_874 asemeComment
highlight default link asemeComment_877 asemeComment
highlight default link asemeComment_880 asemeComment
highlight default link asemeComment_881 asemeComment
highlight default link asemeComment_884 asemeComment
highlight default link asemeComment_886 asemeComment
highlight default link asemeComment_888 asemeComment
highlight default link asemeComment_891 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_912 asemeComment
highlight default link asemeComment_914 asemeComment
highlight default link asemeComment_916 asemeComment
highlight default link asemeComment_918 asemeComment
highlight default link asemeComment_92 asemeComment
highlight default link asemeComment_920 asemeComment
highlight default link asemeComment_922 asemeComment
highlight default link asemeComment_924 asemeComment
highlight default link asemeComment_927 asemeComment
highlight default link asemeComment_930 asemeComment
highlight default link asemeComment_933 asemeComment
highlight default link asemeComment_937 asemeComment
highlight default link asemeComment_940 asemeComment
highlight default link asemeComment_95 asemeComment
highlight default link asemeComment_966 asemeComment
highlight default link asemeComment_969 asemeComment
highlight default link asemeComment_977 asemeComment
highlight default link asemeComment_98 asemeComment
highlight default link asemeComment_980 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_104 asemeDeclaration
highlight default link asemeDeclaration_126 asemeDeclaration
highlight default link asemeDeclaration_131 asemeDeclaration
highlight default link asemeDeclaration_161 asemeDeclaration
highlight default link asemeDeclaration_175 asemeDeclaration
highlight default link asemeDeclaration_181 asemeDeclaration
highlight default link asemeDeclaration_184 asemeDeclaration
highlight default link asemeDeclaration_195 asemeDeclaration
highlight default link asemeDeclaration_213 asemeDeclaration
highlight default link asemeDeclaration_216 asemeDeclaration
highlight default link asemeDeclaration_227 asemeDeclaration
highlight default link asemeDeclaration_278 asemeDeclaration
highlight default link asemeDeclaration_283 asemeDeclaration
highlight default link asemeDeclaration_297 asemeDeclaration
highlight default link asemeDeclaration_311 asemeDeclaration
highlight default link asemeDeclaration_337 asemeDeclaration
highlight default link asemeDeclaration_340 asemeDeclaration
highlight default link asemeDeclaration_368 asemeDeclaration
highlight default link asemeDeclaration_372 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_417 asemeDeclaration
highlight default link asemeDeclaration_463 asemeDeclaration
highlight default link asemeDeclaration_469 asemeDeclaration
highlight default link asemeDeclaration_481 asemeDeclaration
highlight default link asemeDeclaration_517 asemeDeclaration
highlight default link asemeDeclaration_533 asemeDeclaration
highlight default link asemeDeclaration_584 asemeDeclaration
highlight default link asemeDeclaration_589 asemeDeclaration
highlight default link asemeDeclaration_613 asemeDeclaration
highlight default link asemeDeclaration_66 asemeDeclaration
highlight default link asemeDeclaration_672 asemeDeclaration
highlight default link asemeDeclaration_719 asemeDeclaration
highlight default link asemeDeclaration_722 asemeDeclaration
highlight default link asemeDeclaration_728 asemeDeclaration
highlight default link asemeDeclaration_738 asemeDeclaration
highlight default link asemeDeclaration_745 asemeDeclaration
highlight default link asemeDeclaration_748 asemeDeclaration
highlight default link asemeDeclaration_772 asemeDeclaration
highlight default link asemeDeclaration_78 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_813 asemeDeclaration
highlight default link asemeDeclaration_864 asemeDeclaration
highlight default link asemeDeclaration_869 asemeDeclaration
highlight default link asemeDeclaration_871 asemeDeclaration
highlight default link asemeDeclaration_873 asemeDeclaration
highlight default link asemeDeclaration_879 asemeDeclaration
highlight default link asemeDeclaration_939 asemeDeclaration
highlight default link asemeDeclaration_94 asemeDeclaration
highlight default link asemeDeclaration_968 asemeDeclaration
highlight default link asemeDeclaration_979 asemeDeclaration
highlight default link asemeLogic_13 asemeLogic
highlight default link asemeLogic_248 asemeLogic
highlight default link asemeLogic_395 asemeLogic
highlight default link asemeLogic_432 asemeLogic
highlight default link asemeLogic_48 asemeLogic
highlight default link asemeLogic_554 asemeLogic
highlight default link asemeLogic_795 asemeLogic
highlight default link asemeLogic_834 asemeLogic
highlight default link asemeLogic_895 asemeLogic
highlight default link asemeName_144 asemeName
highlight default link asemeName_151 asemeName
highlight default link asemeName_156 asemeName
highlight default link asemeName_159 asemeName
highlight default link asemeName_173 asemeName
highlight default link asemeName_174 asemeName
highlight default link asemeName_211 asemeName
highlight default link asemeName_212 asemeName
highlight default link asemeName_268 asemeName
highlight default link asemeName_276 asemeName
highlight default link asemeName_281 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_313 asemeName
highlight default link asemeName_321 asemeName
highlight default link asemeName_333 asemeName
highlight default link asemeName_349 asemeName
highlight default link asemeName_360 asemeName
highlight default link asemeName_367 asemeName
highlight default link asemeName_370 asemeName
highlight default link asemeName_528 asemeName
highlight default link asemeName_531 asemeName
highlight default link asemeName_574 asemeName
highlight default link asemeName_582 asemeName
highlight default link asemeName_587 asemeName
highlight default link asemeName_591 asemeName
highlight default link asemeName_599 asemeName
highlight default link asemeName_611 asemeName
highlight default link asemeName_64 asemeName
highlight default link asemeName_651 asemeName
highlight default link asemeName_659 asemeName
highlight default link asemeName_670 asemeName
highlight default link asemeName_717 asemeName
highlight default link asemeName_73 asemeName
highlight default link asemeName_754 asemeName
highlight default link asemeName_758 asemeName
highlight default link asemeName_764 asemeName
highlight default link asemeName_766 asemeName
highlight default link asemeName_85 asemeName
highlight default link asemeName_854 asemeName
highlight default link asemeName_862 asemeName
highlight default link asemeName_867 asemeName
highlight default link asemeName_89 asemeName
highlight default link asemeName_90 asemeName
highlight default link asemeName_911 asemeName
highlight default link asemeName_926 asemeName
highlight default link asemeName_928 asemeName
highlight default link asemeName_934 asemeName
highlight default link asemeName_96 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_11 asemeNumber
highlight default link asemeNumber_110 asemeNumber
highlight default link asemeNumber_117 asemeNumber
highlight default link asemeNumber_218 asemeNumber
highlight default link asemeNumber_222 asemeNumber
highlight default link asemeNumber_246 asemeNumber
highlight default link asemeNumber_30 asemeNumber
highlight default link asemeNumber_327 asemeNumber
highlight default link asemeNumber_329 asemeNumber
highlight default link asemeNumber_344 asemeNumber
highlight default link asemeNumber_355 asemeNumber
highlight default link asemeNumber_374 asemeNumber
highlight default link asemeNumber_378 asemeNumber
highlight default link asemeNumber_393 asemeNumber
highlight default link asemeNumber_412 asemeNumber
highlight default link asemeNumber_414 asemeNumber
highlight default link asemeNumber_430 asemeNumber
highlight default link asemeNumber_448 asemeNumber
highlight default link asemeNumber_452 asemeNumber
highlight default link asemeNumber_46 asemeNumber
highlight default link asemeNumber_552 asemeNumber
highlight default link asemeNumber_605 asemeNumber
highlight default link asemeNumber_607 asemeNumber
highlight default link asemeNumber_622 asemeNumber
highlight default link asemeNumber_625 asemeNumber
highlight default link asemeNumber_628 asemeNumber
highlight default link asemeNumber_637 asemeNumber
highlight default link asemeNumber_68 asemeNumber
highlight default link asemeNumber_681 asemeNumber
highlight default link asemeNumber_684 asemeNumber
highlight default link asemeNumber_687 asemeNumber
highlight default link asemeNumber_696 asemeNumber
highlight default link asemeNumber_762 asemeNumber
highlight default link asemeNumber_770 asemeNumber
highlight default link asemeNumber_775 asemeNumber
highlight default link asemeNumber_779 asemeNumber
highlight default link asemeNumber_793 asemeNumber
highlight default link asemeNumber_80 asemeNumber
highlight default link asemeNumber_811 asemeNumber
highlight default link asemeNumber_832 asemeNumber
highlight default link asemeNumber_893 asemeNumber
highlight default link asemeNumber_917 asemeNumber
highlight default link asemeNumber_921 asemeNumber
highlight default link asemeNumber_942 asemeNumber
highlight default link asemeNumber_948 asemeNumber
highlight default link asemeNumber_954 asemeNumber
highlight default link asemeNumber_960 asemeNumber
highlight default link asemeNumber_971 asemeNumber
highlight default link asemeNumber_983 asemeNumber
highlight default link asemeOperator_135 asemeOperator
highlight default link asemeOperator_26 asemeOperator
highlight default link asemeOperator_261 asemeOperator
highlight default link asemeOperator_263 asemeOperator
highlight default link asemeOperator_280 asemeOperator
highlight default link asemeOperator_330 asemeOperator
highlight default link asemeOperator_332 asemeOperator
highlight default link asemeOperator_364 asemeOperator
highlight default link asemeOperator_369 asemeOperator
highlight default link asemeOperator_379 asemeOperator
highlight default link asemeOperator_408 asemeOperator
highlight default link asemeOperator_415 asemeOperator
highlight default link asemeOperator_445 asemeOperator
highlight default link asemeOperator_450 asemeOperator
highlight default link asemeOperator_455 asemeOperator
highlight default link asemeOperator_457 asemeOperator
highlight default link asemeOperator_460 asemeOperator
highlight default link asemeOperator_485 asemeOperator
highlight default link asemeOperator_495 asemeOperator
highlight default link asemeOperator_521 asemeOperator
highlight default link asemeOperator_567 asemeOperator
highlight default link asemeOperator_569 asemeOperator
highlight default link asemeOperator_586 asemeOperator
highlight default link asemeOperator_608 asemeOperator
highlight default link asemeOperator_61 asemeOperator
highlight default link asemeOperator_610 asemeOperator
highlight default link asemeOperator_63 asemeOperator
highlight default link asemeOperator_70 asemeOperator
highlight default link asemeOperator_715 asemeOperator
highlight default link asemeOperator_730 asemeOperator
highlight default link asemeOperator_732 asemeOperator
highlight default link asemeOperator_735 asemeOperator
highlight default link asemeOperator_777 asemeOperator
highlight default link asemeOperator_808 asemeOperator
highlight default link asemeOperator_82 asemeOperator
highlight default link asemeOperator_847 asemeOperator
highlight default link asemeOperator_849 asemeOperator
highlight default link asemeOperator_866 asemeOperator
highlight default link asemeOperator_908 asemeOperator
highlight default link asemeOperator_910 asemeOperator
highlight default link asemeOperator_925 asemeOperator
highlight default link asemeOperator_944 asemeOperator
highlight default link asemeOperator_950 asemeOperator
highlight default link asemeOperator_956 asemeOperator
highlight default link asemeOperator_962 asemeOperator
highlight default link asemeOperator_973 asemeOperator
highlight default link asemePunctuation_100 asemePunctuation
highlight default link asemePunctuation_122 asemePunctuation
highlight default link asemePunctuation_128 asemePunctuation
highlight default link asemePunctuation_140 asemePunctuation
highlight default link asemePunctuation_142 asemePunctuation
highlight default link asemePunctuation_148 asemePunctuation
highlight default link asemePunctuation_150 asemePunctuation
highlight default link asemePunctuation_155 asemePunctuation
highlight default link asemePunctuation_158 asemePunctuation
highlight default link asemePunctuation_170 asemePunctuation
highlight default link asemePunctuation_177 asemePunctuation
highlight default link asemePunctuation_183 asemePunctuation
highlight default link asemePunctuation_188 asemePunctuation
highlight default link asemePunctuation_191 asemePunctuation
highlight default link asemePunctuation_208 asemePunctuation
highlight default link asemePunctuation_215 asemePunctuation
highlight default link asemePunctuation_220 asemePunctuation
highlight default link asemePunctuation_223 asemePunctuation
highlight default link asemePunctuation_225 asemePunctuation
highlight default link asemePunctuation_232 asemePunctuation
highlight default link asemePunctuation_235 asemePunctuation
highlight default link asemePunctuation_262 asemePunctuation
highlight default link asemePunctuation_266 asemePunctuation
highlight default link asemePunctuation_27 asemePunctuation
highlight default link asemePunctuation_274 asemePunctuation
highlight default link asemePunctuation_289 asemePunctuation
highlight default link asemePunctuation_303 asemePunctuation
highlight default link asemePunctuation_315 asemePunctuation
highlight default link asemePunctuation_319 asemePunctuation
highlight default link asemePunctuation_322 asemePunctuation
highlight default link asemePunctuation_324 asemePunctuation
highlight default link asemePunctuation_33 asemePunctuation
highlight default link asemePunctuation_331 asemePunctuation
highlight default link asemePunctuation_334 asemePunctuation
highlight default link asemePunctuation_35 asemePunctuation
highlight default link asemePunctuation_361 asemePunctuation
highlight default link asemePunctuation_366 asemePunctuation
highlight default link asemePunctuation_382 asemePunctuation
highlight default link asemePunctuation_409 asemePunctuation
highlight default link asemePunctuation_410 asemePunctuation
highlight default link asemePunctuation_416 asemePunctuation
highlight default link asemePunctuation_419 asemePunctuation
highlight default link asemePunctuation_446 asemePunctuation
highlight default link asemePunctuation_447 asemePunctuation
highlight default link asemePunctuation_454 asemePunctuation
highlight default link asemePunctuation_465 asemePunctuation
highlight default link asemePunctuation_477 asemePunctuation
highlight default link asemePunctuation_498 asemePunctuation
highlight default link asemePunctuation_502 asemePunctuation
highlight default link asemePunctuation_505 asemePunctuation
highlight default link asemePunctuation_508 asemePunctuation
highlight default link asemePunctuation_513 asemePunctuation
highlight default link asemePunctuation_524 asemePunctuation
highlight default link asemePunctuation_538 asemePunctuation
highlight default link asemePunctuation_541 asemePunctuation
highlight default link asemePunctuation_568 asemePunctuation
highlight default link asemePunctuation_572 asemePunctuation
highlight default link asemePunctuation_580 asemePunctuation
highlight default link asemePunctuation_593 asemePunctuation
highlight default link asemePunctuation_597 asemePunctuation
highlight default link asemePunctuation_600 asemePunctuation
highlight default link asemePunctuation_602 asemePunctuation
highlight default link asemePunctuation_609 asemePunctuation
highlight default link asemePunctuation_612 asemePunctuation
highlight default link asemePunctuation_62 asemePunctuation
highlight default link asemePunctuation_649 asemePunctuation
highlight default link asemePunctuation_653 asemePunctuation
highlight default link asemePunctuation_657 asemePunctuation
highlight default link asemePunctuation_667 asemePunctuation
highlight default link asemePunctuation_669 asemePunctuation
highlight default link asemePunctuation_671 asemePunctuation
highlight default link asemePunctuation_712 asemePunctuation
highlight default link asemePunctuation_718 asemePunctuation
highlight default link asemePunctuation_72 asemePunctuation
highlight default link asemePunctuation_724 asemePunctuation
highlight default link asemePunctuation_74 asemePunctuation
highlight default link asemePunctuation_740 asemePunctuation
highlight default link asemePunctuation_774 asemePunctuation
highlight default link asemePunctuation_782 asemePunctuation
highlight default link asemePunctuation_809 asemePunctuation
highlight default link asemePunctuation_810 asemePunctuation
highlight default link asemePunctuation_818 asemePunctuation
highlight default link asemePunctuation_821 asemePunctuation
highlight default link asemePunctuation_84 asemePunctuation
highlight default link asemePunctuation_848 asemePunctuation
highlight default link asemePunctuation_852 asemePunctuation
highlight default link asemePunctuation_860 asemePunctuation
highlight default link asemePunctuation_875 asemePunctuation
highlight default link asemePunctuation_882 asemePunctuation
highlight default link asemePunctuation_909 asemePunctuation
highlight default link asemePunctuation_915 asemePunctuation
highlight default link asemePunctuation_919 asemePunctuation
highlight default link asemePunctuation_923 asemePunctuation
highlight default link asemePunctuation_929 asemePunctuation
highlight default link asemePunctuation_932 asemePunctuation
highlight default link asemePunctuation_935 asemePunctuation
highlight default link asemePunctuation_945 asemePunctuation
highlight default link asemePunctuation_946 asemePunctuation
highlight default link asemePunctuation_951 asemePunctuation
highlight default link asemePunctuation_952 asemePunctuation
highlight default link asemePunctuation_957 asemePunctuation
highlight default link asemePunctuation_958 asemePunctuation
highlight default link asemePunctuation_963 asemePunctuation
highlight default link asemePunctuation_964 asemePunctuation
highlight default link asemePunctuation_974 asemePunctuation
highlight default link asemePunctuation_975 asemePunctuation
highlight default link asemePunctuation_986 asemePunctuation
highlight default link asemeReference_106 asemeReference
highlight default link asemeReference_113 asemeReference
highlight default link asemeReference_121 asemeReference
highlight default link asemeReference_124 asemeReference
highlight default link asemeReference_125 asemeReference
highlight default link asemeReference_163 asemeReference
highlight default link asemeReference_169 asemeReference
highlight default link asemeReference_186 asemeReference
highlight default link asemeReference_193 asemeReference
highlight default link asemeReference_194 asemeReference
highlight default link asemeReference_197 asemeReference
highlight default link asemeReference_201 asemeReference
highlight default link asemeReference_204 asemeReference
highlight default link asemeReference_207 asemeReference
highlight default link asemeReference_236 asemeReference
highlight default link asemeReference_238 asemeReference
highlight default link asemeReference_242 asemeReference
highlight default link asemeReference_25 asemeReference
highlight default link asemeReference_260 asemeReference
highlight default link asemeReference_285 asemeReference
highlight default link asemeReference_287 asemeReference
highlight default link asemeReference_291 asemeReference
highlight default link asemeReference_292 asemeReference
highlight default link asemeReference_294 asemeReference
highlight default link asemeReference_295 asemeReference
highlight default link asemeReference_299 asemeReference
highlight default link asemeReference_301 asemeReference
highlight default link asemeReference_305 asemeReference
highlight default link asemeReference_306 asemeReference
highlight default link asemeReference_308 asemeReference
highlight default link asemeReference_309 asemeReference
highlight default link asemeReference_31 asemeReference
highlight default link asemeReference_32 asemeReference
highlight default link asemeReference_328 asemeReference
highlight default link asemeReference_36 asemeReference
highlight default link asemeReference_363 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_383 asemeReference
highlight default link asemeReference_385 asemeReference
highlight default link asemeReference_389 asemeReference
highlight default link asemeReference_407 asemeReference
highlight default link asemeReference_413 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_420 asemeReference
highlight default link asemeReference_422 asemeReference
highlight default link asemeReference_426 asemeReference
highlight default link asemeReference_444 asemeReference
highlight default link asemeReference_475 asemeReference
highlight default link asemeReference_479 asemeReference
highlight default link asemeReference_480 asemeReference
highlight default link asemeReference_483 asemeReference
highlight default link asemeReference_487 asemeReference
highlight default link asemeReference_491 asemeReference
highlight default link asemeReference_494 asemeReference
highlight default link asemeReference_497 asemeReference
highlight default link asemeReference_500 asemeReference
highlight default link asemeReference_504 asemeReference
highlight default link asemeReference_507 asemeReference
highlight default link asemeReference_510 asemeReference
highlight default link asemeReference_512 asemeReference
highlight default link asemeReference_515 asemeReference
highlight default link asemeReference_519 asemeReference
highlight default link asemeReference_523 asemeReference
highlight default link asemeReference_542 asemeReference
highlight default link asemeReference_544 asemeReference
highlight default link asemeReference_548 asemeReference
highlight default link asemeReference_566 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_60 asemeReference
highlight default link asemeReference_606 asemeReference
highlight default link asemeReference_615 asemeReference
highlight default link asemeReference_619 asemeReference
highlight default link asemeReference_634 asemeReference
highlight default link asemeReference_640 asemeReference
highlight default link asemeReference_643 asemeReference
highlight default link asemeReference_661 asemeReference
highlight default link asemeReference_664 asemeReference
highlight default link asemeReference_665 asemeReference
highlight default link asemeReference_666 asemeReference
highlight default link asemeReference_674 asemeReference
highlight default link asemeReference_678 asemeReference
highlight default link asemeReference_693 asemeReference
highlight default link asemeReference_699 asemeReference
highlight default link asemeReference_702 asemeReference
highlight default link asemeReference_706 asemeReference
highlight default link asemeReference_709 asemeReference
highlight default link asemeReference_710 asemeReference
highlight default link asemeReference_711 asemeReference
highlight default link asemeReference_750 asemeReference
highlight default link asemeReference_783 asemeReference
highlight default link asemeReference_785 asemeReference
highlight default link asemeReference_789 asemeReference
highlight default link asemeReference_807 asemeReference
highlight default link asemeReference_822 asemeReference
highlight default link asemeReference_824 asemeReference
highlight default link asemeReference_828 asemeReference
highlight default link asemeReference_846 asemeReference
highlight default link asemeReference_883 asemeReference
highlight default link asemeReference_885 asemeReference
highlight default link asemeReference_889 asemeReference
highlight default link asemeReference_907 asemeReference
highlight default link asemeReference_931 asemeReference
highlight default link asemeReference_943 asemeReference
highlight default link asemeReference_949 asemeReference
highlight default link asemeReference_955 asemeReference
highlight default link asemeReference_961 asemeReference
highlight default link asemeReference_972 asemeReference
highlight default link asemeReference_984 asemeReference
highlight default link asemeReference_985 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_133 asemeText
highlight default link asemeText_172 asemeText
highlight default link asemeText_210 asemeText
highlight default link asemeText_226 asemeText
highlight default link asemeText_245 asemeText
highlight default link asemeText_28 asemeText
highlight default link asemeText_29 asemeText
highlight default link asemeText_325 asemeText
highlight default link asemeText_339 asemeText
highlight default link asemeText_392 asemeText
highlight default link asemeText_411 asemeText
highlight default link asemeText_429 asemeText
highlight default link asemeText_45 asemeText
highlight default link asemeText_526 asemeText
highlight default link asemeText_527 asemeText
highlight default link asemeText_530 asemeText
highlight default link asemeText_551 asemeText
highlight default link asemeText_603 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_714 asemeText
highlight default link asemeText_721 asemeText
highlight default link asemeText_755 asemeText
highlight default link asemeText_759 asemeText
highlight default link asemeText_765 asemeText
highlight default link asemeText_767 asemeText
highlight default link asemeText_792 asemeText
highlight default link asemeText_831 asemeText
highlight default link asemeText_892 asemeText
highlight default link asemeText_941 asemeText
highlight default link asemeText_947 asemeText
highlight default link asemeText_953 asemeText
highlight default link asemeText_959 asemeText
highlight default link asemeText_965 asemeText
highlight default link asemeText_967 asemeText
highlight default link asemeText_970 asemeText
highlight default link asemeText_976 asemeText
highlight default link asemeText_978 asemeText
highlight default link asemeText_981 asemeText
highlight default link asemeText_982 asemeText
highlight default link asemeTruth_12 asemeTruth
highlight default link asemeTruth_247 asemeTruth
highlight default link asemeTruth_394 asemeTruth
highlight default link asemeTruth_431 asemeTruth
highlight default link asemeTruth_47 asemeTruth
highlight default link asemeTruth_553 asemeTruth
highlight default link asemeTruth_794 asemeTruth
highlight default link asemeTruth_833 asemeTruth
highlight default link asemeTruth_894 asemeTruth
highlight default link asemeType_139 asemeType
highlight default link asemeType_147 asemeType
highlight default link asemeType_154 asemeType
highlight default link asemeType_231 asemeType
highlight default link asemeType_265 asemeType
highlight default link asemeType_271 asemeType
highlight default link asemeType_273 asemeType
highlight default link asemeType_318 asemeType
highlight default link asemeType_537 asemeType
highlight default link asemeType_571 asemeType
highlight default link asemeType_577 asemeType
highlight default link asemeType_579 asemeType
highlight default link asemeType_596 asemeType
highlight default link asemeType_648 asemeType
highlight default link asemeType_656 asemeType
highlight default link asemeType_817 asemeType
highlight default link asemeType_851 asemeType
highlight default link asemeType_857 asemeType
highlight default link asemeType_859 asemeType
highlight default link asemeType_88 asemeType
highlight default link asemeType_93 asemeType
highlight default link asemeType_99 asemeType
highlight default link asemeDeclaration Statement
highlight default link asemeClause Keyword
highlight default link asemeChoice StorageClass
highlight default link asemeTruth Boolean
highlight default link asemeLogic Operator
highlight default link asemeBuiltIn Type
highlight default link asemeBlock Structure
highlight default link asemeName Identifier
highlight default link asemeType Type
highlight default link asemeCall Function
highlight default link asemeReference asemeNone
highlight default link asemeText String
highlight default link asemeNumber Number
highlight default link asemeOperator Operator
highlight default link asemePunctuation Delimiter
highlight default link asemeComment Comment
let b:current_syntax = "aseme"
