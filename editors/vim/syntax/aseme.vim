" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_992 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_991 /\v\w+/
syntax match asemeNumber_990 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_989 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_988 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_993 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_988,asemeText_989,asemeNumber_990,asemeReference_991,asemeReference_992,asemePunctuation_993,asemeComment
syntax match asemeReference_32 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_31 /\v\w+/ contained
syntax match asemeNumber_30 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_29 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_28 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_33 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_66,asemeDeclaration_78,asemeDeclaration_104,asemeDeclaration_131,asemeDeclaration_161,asemeDeclaration_184,asemeDeclaration_216,asemeDeclaration_476,asemeDeclaration_752,asemeDeclaration_755,asemeDeclaration_886,asemeDeclaration_946,asemeDeclaration_975,asemeDeclaration_986,asemeText_988,asemeText_989,asemeNumber_990,asemeReference_991,asemeReference_992,asemePunctuation_993,asemeComment
syntax match asemeDeclaration_986 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_985,asemeComment_987 skipwhite skipempty
syntax region asemeComment_987 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_985,asemeComment_987 skipwhite skipempty
syntax match asemeComment_987 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_985,asemeComment_987 skipwhite skipempty
syntax match asemeText_985 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_984 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_982,asemeText_983
syntax match asemeText_983 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_984 skipwhite skipempty
syntax region asemeComment_984 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_984 skipwhite skipempty
syntax match asemeComment_984 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_984 skipwhite skipempty
syntax region asemePunctuation_982 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_965,asemeText_977,asemeNumber_978,asemeReference_979,asemeOperator_980,asemePunctuation_981,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_981 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_980 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_979 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_978 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_977 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_975 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_974,asemeComment_976 skipwhite skipempty
syntax region asemeComment_976 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_974,asemeComment_976 skipwhite skipempty
syntax match asemeComment_976 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_974,asemeComment_976 skipwhite skipempty
syntax match asemeText_974 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_973 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_971,asemeText_972
syntax match asemeText_972 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_973 skipwhite skipempty
syntax region asemeComment_973 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_973 skipwhite skipempty
syntax match asemeComment_973 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_973 skipwhite skipempty
syntax region asemePunctuation_971 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_965,asemeText_966,asemeNumber_967,asemeReference_968,asemeOperator_969,asemePunctuation_970,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_970 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_969 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_968 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_967 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_966 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_965 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_959,asemeText_960,asemeNumber_961,asemeReference_962,asemeOperator_963,asemePunctuation_964,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_964 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_963 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_962 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_961 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_960 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_959 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_953,asemeText_954,asemeNumber_955,asemeReference_956,asemeOperator_957,asemePunctuation_958,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_958 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_957 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_956 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_955 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_954 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_953 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_948,asemeNumber_949,asemeReference_950,asemeOperator_951,asemePunctuation_952,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_952 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_951 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_950 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_949 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_948 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_946 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_945,asemeComment_947 skipwhite skipempty
syntax region asemeComment_947 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_945,asemeComment_947 skipwhite skipempty
syntax match asemeComment_947 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_945,asemeComment_947 skipwhite skipempty
syntax match asemeBlock_945 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_944 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_942,asemeBlock_943
syntax match asemeBlock_943 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_944 skipwhite skipempty
syntax region asemeComment_944 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_944 skipwhite skipempty
syntax match asemeComment_944 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_944 skipwhite skipempty
syntax region asemePunctuation_942 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_941,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_941 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_923 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_920,asemePunctuation_930,asemePunctuation_936,asemePunctuation_939
syntax match asemePunctuation_939 /\v\:/ contained nextgroup=asemeReference_938,asemeComment_940 skipwhite skipempty
syntax region asemeComment_940 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_938,asemeComment_940 skipwhite skipempty
syntax match asemeComment_940 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_938,asemeComment_940 skipwhite skipempty
syntax match asemeReference_938 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_923 skipwhite skipempty
syntax match asemePunctuation_936 /\v\,/ contained nextgroup=asemeName_933,asemeName_935,asemeComment_937 skipwhite skipempty
syntax region asemeComment_937 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_933,asemeName_935,asemeComment_937 skipwhite skipempty
syntax match asemeComment_937 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_933,asemeName_935,asemeComment_937 skipwhite skipempty
syntax match asemeName_935 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_923 skipwhite skipempty
syntax match asemeName_933 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_932,asemeComment_934 skipwhite skipempty
syntax region asemeComment_934 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_932,asemeComment_934 skipwhite skipempty
syntax match asemeComment_934 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_932,asemeComment_934 skipwhite skipempty
syntax match asemeOperator_932 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemePunctuation_930 /\v\[/ contained nextgroup=asemeNumber_928,asemeComment_931 skipwhite skipempty
syntax region asemeComment_931 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_928,asemeComment_931 skipwhite skipempty
syntax match asemeComment_931 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_928,asemeComment_931 skipwhite skipempty
syntax match asemeNumber_928 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_926,asemeComment_929 skipwhite skipempty
syntax region asemeComment_929 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_926,asemeComment_929 skipwhite skipempty
syntax match asemeComment_929 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_926,asemeComment_929 skipwhite skipempty
syntax match asemePunctuation_926 /\v\.\./ contained nextgroup=asemeNumber_924,asemeComment_927 skipwhite skipempty
syntax region asemeComment_927 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_924,asemeComment_927 skipwhite skipempty
syntax match asemeComment_927 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_924,asemeComment_927 skipwhite skipempty
syntax match asemeNumber_924 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_922,asemeComment_925 skipwhite skipempty
syntax region asemeComment_925 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_922,asemeComment_925 skipwhite skipempty
syntax match asemeComment_925 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_922,asemeComment_925 skipwhite skipempty
syntax match asemePunctuation_922 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_923 skipwhite skipempty
syntax region asemeComment_923 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_923 skipwhite skipempty
syntax match asemeComment_923 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_923 skipwhite skipempty
syntax match asemeClause_920 /\vwith%(<|>)/ contained nextgroup=asemeName_918,asemeComment_921 skipwhite skipempty
syntax region asemeComment_921 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_918,asemeComment_921 skipwhite skipempty
syntax match asemeComment_921 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_918,asemeComment_921 skipwhite skipempty
syntax match asemeName_918 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_917,asemeComment_919 skipwhite skipempty
syntax region asemeComment_919 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_917,asemeComment_919 skipwhite skipempty
syntax match asemeComment_919 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_917,asemeComment_919 skipwhite skipempty
syntax match asemeOperator_917 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeDeclaration_886 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_885,asemeComment_887 skipwhite skipempty
syntax region asemeComment_887 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_885,asemeComment_887 skipwhite skipempty
syntax match asemeComment_887 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_885,asemeComment_887 skipwhite skipempty
syntax match asemeBlock_885 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_884 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_882,asemeBlock_883
syntax match asemeBlock_883 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_884 skipwhite skipempty
syntax region asemeComment_884 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_884 skipwhite skipempty
syntax match asemeComment_884 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_884 skipwhite skipempty
syntax region asemePunctuation_882 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_779,asemeNumber_786,asemeDeclaration_820,asemeDeclaration_871,asemeDeclaration_876,asemeDeclaration_878,asemeDeclaration_880,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_880 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_881 skipwhite skipempty
syntax region asemeComment_881 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_881 skipwhite skipempty
syntax match asemeComment_881 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_881 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_725
syntax match asemeDeclaration_878 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_879 skipwhite skipempty
syntax region asemeComment_879 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_879 skipwhite skipempty
syntax match asemeComment_879 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_879 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_678
syntax match asemeDeclaration_876 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_874,asemeComment_877 skipwhite skipempty
syntax region asemeComment_877 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_874,asemeComment_877 skipwhite skipempty
syntax match asemeComment_877 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_874,asemeComment_877 skipwhite skipempty
syntax match asemeName_874 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_873,asemeComment_875 skipwhite skipempty
syntax region asemeComment_875 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_873,asemeComment_875 skipwhite skipempty
syntax match asemeComment_875 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_873,asemeComment_875 skipwhite skipempty
syntax match asemeOperator_873 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_871 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_869,asemeComment_872 skipwhite skipempty
syntax region asemeComment_872 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_869,asemeComment_872 skipwhite skipempty
syntax match asemeComment_872 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_869,asemeComment_872 skipwhite skipempty
syntax match asemeName_869 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_867,asemeComment_870 skipwhite skipempty
syntax region asemeComment_870 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_867,asemeComment_870 skipwhite skipempty
syntax match asemeComment_870 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_867,asemeComment_870 skipwhite skipempty
syntax match asemePunctuation_867 /\v\:/ contained nextgroup=asemeBuiltIn_865,asemeType_866,asemeComment_868 skipwhite skipempty
syntax region asemeComment_868 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_865,asemeType_866,asemeComment_868 skipwhite skipempty
syntax match asemeComment_868 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_865,asemeType_866,asemeComment_868 skipwhite skipempty
syntax match asemeType_866 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeBuiltIn_865 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_825,asemeOperator_856,asemeName_861,asemeBuiltIn_863,asemeType_864
syntax match asemeType_864 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeBuiltIn_863 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeName_861 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_859,asemeComment_862 skipwhite skipempty
syntax region asemeComment_862 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_859,asemeComment_862 skipwhite skipempty
syntax match asemeComment_862 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_859,asemeComment_862 skipwhite skipempty
syntax match asemePunctuation_859 /\v\:/ contained nextgroup=asemeBuiltIn_857,asemeType_858,asemeComment_860 skipwhite skipempty
syntax region asemeComment_860 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_857,asemeType_858,asemeComment_860 skipwhite skipempty
syntax match asemeComment_860 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_857,asemeType_858,asemeComment_860 skipwhite skipempty
syntax match asemeType_858 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeBuiltIn_857 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeOperator_856 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemePunctuation_825 /\v\:/ contained nextgroup=asemeBuiltIn_822,asemeType_824,asemeComment_826 skipwhite skipempty
syntax region asemeComment_826 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_822,asemeType_824,asemeComment_826 skipwhite skipempty
syntax match asemeComment_826 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_822,asemeType_824,asemeComment_826 skipwhite skipempty
syntax match asemeType_824 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeBuiltIn_822 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax region asemeComment_823 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeComment_823 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_823 skipwhite skipempty
syntax match asemeDeclaration_820 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_818,asemeComment_821 skipwhite skipempty
syntax region asemeComment_821 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_818,asemeComment_821 skipwhite skipempty
syntax match asemeComment_821 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_818,asemeComment_821 skipwhite skipempty
syntax match asemeNumber_818 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_817,asemeComment_819 skipwhite skipempty
syntax region asemeComment_819 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_817,asemeComment_819 skipwhite skipempty
syntax match asemeComment_819 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_817,asemeComment_819 skipwhite skipempty
syntax match asemePunctuation_817 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeNumber_786 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_784,asemeComment_787 skipwhite skipempty
syntax region asemeComment_787 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_784,asemeComment_787 skipwhite skipempty
syntax match asemeComment_787 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_784,asemeComment_787 skipwhite skipempty
syntax match asemeOperator_784 /\v\-\>/ contained nextgroup=asemeNumber_782,asemeComment_785 skipwhite skipempty
syntax region asemeComment_785 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_782,asemeComment_785 skipwhite skipempty
syntax match asemeComment_785 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_782,asemeComment_785 skipwhite skipempty
syntax match asemeNumber_782 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_781,asemeComment_783 skipwhite skipempty
syntax region asemeComment_783 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_781,asemeComment_783 skipwhite skipempty
syntax match asemeComment_783 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_781,asemeComment_783 skipwhite skipempty
syntax match asemePunctuation_781 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeDeclaration_779 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_777,asemeComment_780 skipwhite skipempty
syntax region asemeComment_780 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_777,asemeComment_780 skipwhite skipempty
syntax match asemeComment_780 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_777,asemeComment_780 skipwhite skipempty
syntax match asemeNumber_777 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_775,asemeComment_778 skipwhite skipempty
syntax region asemeComment_778 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_775,asemeComment_778 skipwhite skipempty
syntax match asemeComment_778 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_775,asemeComment_778 skipwhite skipempty
syntax match asemeChoice_775 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_773,asemeText_774,@asemeChartNodeInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_773,asemeText_774,@asemeChartNodeInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_773,asemeText_774,@asemeChartNodeInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax match asemeText_774 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeName_773 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_759,asemeChoice_763,asemeNumber_769,asemeName_771,asemeText_772
syntax match asemeText_772 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeName_771 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeNumber_769 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_767,asemeComment_770 skipwhite skipempty
syntax region asemeComment_770 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_767,asemeComment_770 skipwhite skipempty
syntax match asemeComment_770 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_767,asemeComment_770 skipwhite skipempty
syntax match asemeChoice_767 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_765,asemeText_766,@asemeChartNodeInBodyOfStatechart,asemeComment_768 skipwhite skipempty
syntax region asemeComment_768 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_765,asemeText_766,@asemeChartNodeInBodyOfStatechart,asemeComment_768 skipwhite skipempty
syntax match asemeComment_768 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_765,asemeText_766,@asemeChartNodeInBodyOfStatechart,asemeComment_768 skipwhite skipempty
syntax match asemeText_766 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeName_765 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeChoice_763 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_761,asemeText_762,@asemeChartNodeInBodyOfStatechart,asemeComment_764 skipwhite skipempty
syntax region asemeComment_764 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_761,asemeText_762,@asemeChartNodeInBodyOfStatechart,asemeComment_764 skipwhite skipempty
syntax match asemeComment_764 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_761,asemeText_762,@asemeChartNodeInBodyOfStatechart,asemeComment_764 skipwhite skipempty
syntax match asemeText_762 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeName_761 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeClause_759 /\vactivity%(<|>)/ contained nextgroup=asemeReference_757,asemeComment_760 skipwhite skipempty
syntax region asemeComment_760 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_757,asemeComment_760 skipwhite skipempty
syntax match asemeComment_760 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_757,asemeComment_760 skipwhite skipempty
syntax match asemeReference_757 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax region asemeComment_758 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeComment_758 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_758 skipwhite skipempty
syntax match asemeDeclaration_755 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_754,asemeComment_756 skipwhite skipempty
syntax region asemeComment_756 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_754,asemeComment_756 skipwhite skipempty
syntax match asemeComment_756 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_754,asemeComment_756 skipwhite skipempty
syntax match asemeBlock_754 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_479 skipwhite skipempty
syntax match asemeDeclaration_752 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_750,asemeComment_753 skipwhite skipempty
syntax region asemeComment_753 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_750,asemeComment_753 skipwhite skipempty
syntax match asemeComment_753 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_750,asemeComment_753 skipwhite skipempty
syntax match asemeClause_750 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_749,asemeComment_751 skipwhite skipempty
syntax region asemeComment_751 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_749,asemeComment_751 skipwhite skipempty
syntax match asemeComment_751 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_749,asemeComment_751 skipwhite skipempty
syntax match asemeBlock_749 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_479 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_480,asemePunctuation_747,asemeBlock_748
syntax match asemeBlock_748 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_479 skipwhite skipempty
syntax region asemePunctuation_747 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_488,asemeDeclaration_524,asemeDeclaration_540,asemeDeclaration_591,asemeDeclaration_596,asemeDeclaration_620,asemeDeclaration_679,asemeDeclaration_726,asemeDeclaration_735,asemeDeclaration_745,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_745 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_743,asemeComment_746 skipwhite skipempty
syntax region asemeComment_746 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_743,asemeComment_746 skipwhite skipempty
syntax match asemeComment_746 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_743,asemeComment_746 skipwhite skipempty
syntax match asemeBlock_743 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_742,@asemeControlInBodyOfSrm,asemeComment_744 skipwhite skipempty
syntax region asemeComment_744 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_742,@asemeControlInBodyOfSrm,asemeComment_744 skipwhite skipempty
syntax match asemeComment_744 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_742,@asemeControlInBodyOfSrm,asemeComment_744 skipwhite skipempty
syntax match asemeOperator_742 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_461,asemeOperator_737,asemeBlock_740
syntax match asemeBlock_740 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_739,@asemeControlInBodyOfSrm,asemeComment_741 skipwhite skipempty
syntax region asemeComment_741 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_739,@asemeControlInBodyOfSrm,asemeComment_741 skipwhite skipempty
syntax match asemeComment_741 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_739,@asemeControlInBodyOfSrm,asemeComment_741 skipwhite skipempty
syntax match asemeOperator_739 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeOperator_737 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax region asemeComment_738 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeComment_738 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeDeclaration_735 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_734,asemeComment_736 skipwhite skipempty
syntax region asemeComment_736 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_734,asemeComment_736 skipwhite skipempty
syntax match asemeComment_736 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_734,asemeComment_736 skipwhite skipempty
syntax match asemeBlock_734 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_733 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_731,asemeBlock_732
syntax match asemeBlock_732 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_733 skipwhite skipempty
syntax region asemeComment_733 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_733 skipwhite skipempty
syntax match asemeComment_733 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_733 skipwhite skipempty
syntax region asemePunctuation_731 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_729,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_729 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_728,asemeComment_730 skipwhite skipempty
syntax region asemeComment_730 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_728,asemeComment_730 skipwhite skipempty
syntax match asemeComment_730 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_728,asemeComment_730 skipwhite skipempty
syntax match asemeText_728 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_726 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax region asemeComment_727 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeComment_727 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_725
syntax region asemePunctuation_725 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_724,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_724 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_686,asemeClause_689,asemeClause_692,asemeClause_695,asemeClause_698,asemeClause_701,asemeClause_704,asemeClause_707,asemeClause_710,asemeClause_712,asemePunctuation_719,asemeOperator_722
syntax match asemeOperator_722 /\v\=%(\=)@!/ contained nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax region asemeComment_723 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax match asemeComment_723 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax match asemeText_721 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemePunctuation_719 /\v\,/ contained nextgroup=asemeChoice_714,asemeReference_716,asemeReference_717,asemeReference_718,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_714,asemeReference_716,asemeReference_717,asemeReference_718,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_714,asemeReference_716,asemeReference_717,asemeReference_718,asemeComment_720 skipwhite skipempty
syntax match asemeReference_718 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeReference_717 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeReference_716 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeChoice_714 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_713,asemeComment_715 skipwhite skipempty
syntax region asemeComment_715 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_713,asemeComment_715 skipwhite skipempty
syntax match asemeComment_715 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_713,asemeComment_715 skipwhite skipempty
syntax match asemeReference_713 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_712 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_710 /\vends%(<|>)/ contained nextgroup=asemeReference_709,asemeComment_711 skipwhite skipempty
syntax region asemeComment_711 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_709,asemeComment_711 skipwhite skipempty
syntax match asemeComment_711 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_709,asemeComment_711 skipwhite skipempty
syntax match asemeReference_709 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_707 /\vwrites%(<|>)/ contained nextgroup=asemeReference_706,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_706,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_706,asemeComment_708 skipwhite skipempty
syntax match asemeReference_706 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_704 /\vfor%(<|>)/ contained nextgroup=asemeNumber_703,asemeComment_705 skipwhite skipempty
syntax region asemeComment_705 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_703,asemeComment_705 skipwhite skipempty
syntax match asemeComment_705 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_703,asemeComment_705 skipwhite skipempty
syntax match asemeNumber_703 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_701 /\vuses%(<|>)/ contained nextgroup=asemeReference_700,asemeComment_702 skipwhite skipempty
syntax region asemeComment_702 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_700,asemeComment_702 skipwhite skipempty
syntax match asemeComment_702 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_700,asemeComment_702 skipwhite skipempty
syntax match asemeReference_700 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_698 /\vas%(<|>)/ contained nextgroup=asemeChoice_697,asemeComment_699 skipwhite skipempty
syntax region asemeComment_699 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_697,asemeComment_699 skipwhite skipempty
syntax match asemeComment_699 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_697,asemeComment_699 skipwhite skipempty
syntax match asemeChoice_697 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_695 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_694,asemeComment_696 skipwhite skipempty
syntax region asemeComment_696 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_694,asemeComment_696 skipwhite skipempty
syntax match asemeComment_696 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_694,asemeComment_696 skipwhite skipempty
syntax match asemeNumber_694 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_692 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_691,asemeComment_693 skipwhite skipempty
syntax region asemeComment_693 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_691,asemeComment_693 skipwhite skipempty
syntax match asemeComment_693 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_691,asemeComment_693 skipwhite skipempty
syntax match asemeNumber_691 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_689 /\vevery%(<|>)/ contained nextgroup=asemeNumber_688,asemeComment_690 skipwhite skipempty
syntax region asemeComment_690 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_688,asemeComment_690 skipwhite skipempty
syntax match asemeComment_690 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_688,asemeComment_690 skipwhite skipempty
syntax match asemeNumber_688 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeClause_686 /\vreads%(<|>)/ contained nextgroup=asemeChoice_683,asemeReference_685,asemeComment_687 skipwhite skipempty
syntax region asemeComment_687 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_683,asemeReference_685,asemeComment_687 skipwhite skipempty
syntax match asemeComment_687 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_683,asemeReference_685,asemeComment_687 skipwhite skipempty
syntax match asemeReference_685 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeChoice_683 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_681,asemeComment_684 skipwhite skipempty
syntax region asemeComment_684 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_681,asemeComment_684 skipwhite skipempty
syntax match asemeComment_684 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_681,asemeComment_684 skipwhite skipempty
syntax match asemeReference_681 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax region asemeComment_682 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeComment_682 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_682 skipwhite skipempty
syntax match asemeDeclaration_679 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax region asemeComment_680 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax match asemeComment_680 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_678
syntax region asemePunctuation_678 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_677,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_677 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_627,asemeClause_630,asemeClause_633,asemeClause_636,asemeClause_639,asemeClause_642,asemeClause_645,asemeClause_648,asemeClause_651,asemeClause_653,asemePunctuation_660,asemePunctuation_674,asemePunctuation_676
syntax match asemePunctuation_676 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemePunctuation_674 /\v\,/ contained nextgroup=asemeName_666,asemeChoice_669,asemeReference_671,asemeReference_672,asemeReference_673,asemeComment_675 skipwhite skipempty
syntax region asemeComment_675 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_666,asemeChoice_669,asemeReference_671,asemeReference_672,asemeReference_673,asemeComment_675 skipwhite skipempty
syntax match asemeComment_675 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_666,asemeChoice_669,asemeReference_671,asemeReference_672,asemeReference_673,asemeComment_675 skipwhite skipempty
syntax match asemeReference_673 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeReference_672 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeReference_671 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeChoice_669 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_668,asemeComment_670 skipwhite skipempty
syntax region asemeComment_670 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_668,asemeComment_670 skipwhite skipempty
syntax match asemeComment_670 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_668,asemeComment_670 skipwhite skipempty
syntax match asemeReference_668 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeName_666 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_664,asemeComment_667 skipwhite skipempty
syntax region asemeComment_667 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_664,asemeComment_667 skipwhite skipempty
syntax match asemeComment_667 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_664,asemeComment_667 skipwhite skipempty
syntax match asemePunctuation_664 /\v\:/ contained nextgroup=asemeBuiltIn_662,asemeType_663,asemeComment_665 skipwhite skipempty
syntax region asemeComment_665 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_662,asemeType_663,asemeComment_665 skipwhite skipempty
syntax match asemeComment_665 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_662,asemeType_663,asemeComment_665 skipwhite skipempty
syntax match asemeType_663 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeBuiltIn_662 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemePunctuation_660 /\v\(/ contained nextgroup=asemeName_658,asemeComment_661 skipwhite skipempty
syntax region asemeComment_661 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_658,asemeComment_661 skipwhite skipempty
syntax match asemeComment_661 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_658,asemeComment_661 skipwhite skipempty
syntax match asemeName_658 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_656,asemeComment_659 skipwhite skipempty
syntax region asemeComment_659 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_656,asemeComment_659 skipwhite skipempty
syntax match asemeComment_659 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_656,asemeComment_659 skipwhite skipempty
syntax match asemePunctuation_656 /\v\:/ contained nextgroup=asemeBuiltIn_654,asemeType_655,asemeComment_657 skipwhite skipempty
syntax region asemeComment_657 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_654,asemeType_655,asemeComment_657 skipwhite skipempty
syntax match asemeComment_657 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_654,asemeType_655,asemeComment_657 skipwhite skipempty
syntax match asemeType_655 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeBuiltIn_654 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_653 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_651 /\vends%(<|>)/ contained nextgroup=asemeReference_650,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_650,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_650,asemeComment_652 skipwhite skipempty
syntax match asemeReference_650 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_648 /\vwrites%(<|>)/ contained nextgroup=asemeReference_647,asemeComment_649 skipwhite skipempty
syntax region asemeComment_649 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_647,asemeComment_649 skipwhite skipempty
syntax match asemeComment_649 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_647,asemeComment_649 skipwhite skipempty
syntax match asemeReference_647 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_645 /\vfor%(<|>)/ contained nextgroup=asemeNumber_644,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_644,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_644,asemeComment_646 skipwhite skipempty
syntax match asemeNumber_644 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_642 /\vuses%(<|>)/ contained nextgroup=asemeReference_641,asemeComment_643 skipwhite skipempty
syntax region asemeComment_643 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_641,asemeComment_643 skipwhite skipempty
syntax match asemeComment_643 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_641,asemeComment_643 skipwhite skipempty
syntax match asemeReference_641 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_639 /\vas%(<|>)/ contained nextgroup=asemeChoice_638,asemeComment_640 skipwhite skipempty
syntax region asemeComment_640 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_638,asemeComment_640 skipwhite skipempty
syntax match asemeComment_640 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_638,asemeComment_640 skipwhite skipempty
syntax match asemeChoice_638 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_636 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_635,asemeComment_637 skipwhite skipempty
syntax region asemeComment_637 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_635,asemeComment_637 skipwhite skipempty
syntax match asemeComment_637 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_635,asemeComment_637 skipwhite skipempty
syntax match asemeNumber_635 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_633 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_632,asemeComment_634 skipwhite skipempty
syntax region asemeComment_634 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_632,asemeComment_634 skipwhite skipempty
syntax match asemeComment_634 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_632,asemeComment_634 skipwhite skipempty
syntax match asemeNumber_632 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_630 /\vevery%(<|>)/ contained nextgroup=asemeNumber_629,asemeComment_631 skipwhite skipempty
syntax region asemeComment_631 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_629,asemeComment_631 skipwhite skipempty
syntax match asemeComment_631 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_629,asemeComment_631 skipwhite skipempty
syntax match asemeNumber_629 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeClause_627 /\vreads%(<|>)/ contained nextgroup=asemeChoice_624,asemeReference_626,asemeComment_628 skipwhite skipempty
syntax region asemeComment_628 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_624,asemeReference_626,asemeComment_628 skipwhite skipempty
syntax match asemeComment_628 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_624,asemeReference_626,asemeComment_628 skipwhite skipempty
syntax match asemeReference_626 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeChoice_624 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_622,asemeComment_625 skipwhite skipempty
syntax region asemeComment_625 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_622,asemeComment_625 skipwhite skipempty
syntax match asemeComment_625 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_622,asemeComment_625 skipwhite skipempty
syntax match asemeReference_622 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax region asemeComment_623 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeComment_623 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_623 skipwhite skipempty
syntax match asemeDeclaration_620 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_621 skipwhite skipempty
syntax region asemeComment_621 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_621 skipwhite skipempty
syntax match asemeComment_621 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_621 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_619
syntax region asemePunctuation_619 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_618,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_618 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_600,asemePunctuation_604,asemePunctuation_607,asemePunctuation_609,asemeOperator_617
syntax match asemeOperator_617 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemePunctuation_609 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax match asemePunctuation_607 /\v\,/ contained nextgroup=asemeName_606,asemeComment_608 skipwhite skipempty
syntax region asemeComment_608 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_606,asemeComment_608 skipwhite skipempty
syntax match asemeComment_608 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_606,asemeComment_608 skipwhite skipempty
syntax match asemeName_606 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax match asemePunctuation_604 /\v\:/ contained nextgroup=asemeBuiltIn_602,asemeType_603,asemeComment_605 skipwhite skipempty
syntax region asemeComment_605 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_602,asemeType_603,asemeComment_605 skipwhite skipempty
syntax match asemeComment_605 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_602,asemeType_603,asemeComment_605 skipwhite skipempty
syntax match asemeType_603 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax match asemeBuiltIn_602 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax match asemePunctuation_600 /\v\(/ contained nextgroup=asemeName_598,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_598,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_598,asemeComment_601 skipwhite skipempty
syntax match asemeName_598 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax region asemeComment_599 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax match asemeComment_599 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_599 skipwhite skipempty
syntax match asemeDeclaration_596 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_594,asemeComment_597 skipwhite skipempty
syntax region asemeComment_597 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_594,asemeComment_597 skipwhite skipempty
syntax match asemeComment_597 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_594,asemeComment_597 skipwhite skipempty
syntax match asemeName_594 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_593,asemeComment_595 skipwhite skipempty
syntax region asemeComment_595 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_593,asemeComment_595 skipwhite skipempty
syntax match asemeComment_595 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_593,asemeComment_595 skipwhite skipempty
syntax match asemeOperator_593 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_591 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_589,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_589,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_589,asemeComment_592 skipwhite skipempty
syntax match asemeName_589 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_587,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_587,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_587,asemeComment_590 skipwhite skipempty
syntax match asemePunctuation_587 /\v\:/ contained nextgroup=asemeBuiltIn_585,asemeType_586,asemeComment_588 skipwhite skipempty
syntax region asemeComment_588 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_585,asemeType_586,asemeComment_588 skipwhite skipempty
syntax match asemeComment_588 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_585,asemeType_586,asemeComment_588 skipwhite skipempty
syntax match asemeType_586 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeBuiltIn_585 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_545,asemeOperator_576,asemeName_581,asemeBuiltIn_583,asemeType_584
syntax match asemeType_584 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeBuiltIn_583 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeName_581 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_579,asemeComment_582 skipwhite skipempty
syntax region asemeComment_582 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_579,asemeComment_582 skipwhite skipempty
syntax match asemeComment_582 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_579,asemeComment_582 skipwhite skipempty
syntax match asemePunctuation_579 /\v\:/ contained nextgroup=asemeBuiltIn_577,asemeType_578,asemeComment_580 skipwhite skipempty
syntax region asemeComment_580 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_577,asemeType_578,asemeComment_580 skipwhite skipempty
syntax match asemeComment_580 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_577,asemeType_578,asemeComment_580 skipwhite skipempty
syntax match asemeType_578 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeBuiltIn_577 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeOperator_576 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemePunctuation_545 /\v\:/ contained nextgroup=asemeBuiltIn_542,asemeType_544,asemeComment_546 skipwhite skipempty
syntax region asemeComment_546 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_542,asemeType_544,asemeComment_546 skipwhite skipempty
syntax match asemeComment_546 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_542,asemeType_544,asemeComment_546 skipwhite skipempty
syntax match asemeType_544 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeBuiltIn_542 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax region asemeComment_543 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeComment_543 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_543 skipwhite skipempty
syntax match asemeDeclaration_540 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_538,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_538,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_538,asemeComment_541 skipwhite skipempty
syntax match asemeName_538 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_537,@asemeCapabilityInBodyOfSrm,asemeComment_539 skipwhite skipempty
syntax region asemeComment_539 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_537,@asemeCapabilityInBodyOfSrm,asemeComment_539 skipwhite skipempty
syntax match asemeComment_539 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_537,@asemeCapabilityInBodyOfSrm,asemeComment_539 skipwhite skipempty
syntax match asemeText_537 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_528,asemePunctuation_531,asemeText_533,asemeName_535
syntax match asemeName_535 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_534,@asemeCapabilityInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax region asemeComment_536 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_534,@asemeCapabilityInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeComment_536 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_534,@asemeCapabilityInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeText_534 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax match asemeText_533 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax match asemePunctuation_531 /\v\,/ contained nextgroup=asemeReference_530,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_530,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_530,asemeComment_532 skipwhite skipempty
syntax match asemeReference_530 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax match asemeOperator_528 /\v\=%(\=)@!/ contained nextgroup=asemeReference_526,asemeComment_529 skipwhite skipempty
syntax region asemeComment_529 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_526,asemeComment_529 skipwhite skipempty
syntax match asemeComment_529 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_526,asemeComment_529 skipwhite skipempty
syntax match asemeReference_526 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax region asemeComment_527 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax match asemeComment_527 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_527 skipwhite skipempty
syntax match asemeDeclaration_524 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_522,asemeComment_525 skipwhite skipempty
syntax region asemeComment_525 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_522,asemeComment_525 skipwhite skipempty
syntax match asemeComment_525 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_522,asemeComment_525 skipwhite skipempty
syntax match asemeReference_522 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_520,asemeComment_523 skipwhite skipempty
syntax region asemeComment_523 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_520,asemeComment_523 skipwhite skipempty
syntax match asemeComment_523 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_520,asemeComment_523 skipwhite skipempty
syntax match asemePunctuation_520 /\v\./ contained nextgroup=asemeReference_519,asemeComment_521 skipwhite skipempty
syntax region asemeComment_521 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_519,asemeComment_521 skipwhite skipempty
syntax match asemeComment_521 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_519,asemeComment_521 skipwhite skipempty
syntax match asemeReference_519 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_496,asemeClause_499,asemePunctuation_509,asemePunctuation_512,asemeReference_517
syntax match asemeReference_517 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_515,@asemePlaysInBodyOfSrm,asemeComment_518 skipwhite skipempty
syntax region asemeComment_518 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_515,@asemePlaysInBodyOfSrm,asemeComment_518 skipwhite skipempty
syntax match asemeComment_518 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_515,@asemePlaysInBodyOfSrm,asemeComment_518 skipwhite skipempty
syntax match asemePunctuation_515 /\v\./ contained nextgroup=asemeReference_514,asemeComment_516 skipwhite skipempty
syntax region asemeComment_516 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_514,asemeComment_516 skipwhite skipempty
syntax match asemeComment_516 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_514,asemeComment_516 skipwhite skipempty
syntax match asemeReference_514 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemePunctuation_512 /\v\./ contained nextgroup=asemeReference_511,asemeComment_513 skipwhite skipempty
syntax region asemeComment_513 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_511,asemeComment_513 skipwhite skipempty
syntax match asemeComment_513 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_511,asemeComment_513 skipwhite skipempty
syntax match asemeReference_511 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemePunctuation_509 /\v\,/ contained nextgroup=asemeReference_507,asemeComment_510 skipwhite skipempty
syntax region asemeComment_510 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_507,asemeComment_510 skipwhite skipempty
syntax match asemeComment_510 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_507,asemeComment_510 skipwhite skipempty
syntax match asemeReference_507 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\=%(\=)@!|\.))@=/ contained nextgroup=asemeOperator_502,asemePunctuation_505,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_502,asemePunctuation_505,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_502,asemePunctuation_505,asemeComment_508 skipwhite skipempty
syntax match asemePunctuation_505 /\v\./ contained nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax region asemeComment_506 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax match asemeComment_506 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax match asemeReference_504 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemeOperator_502 /\v\=%(\=)@!/ contained nextgroup=asemeReference_501,asemeComment_503 skipwhite skipempty
syntax region asemeComment_503 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_501,asemeComment_503 skipwhite skipempty
syntax match asemeComment_503 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_501,asemeComment_503 skipwhite skipempty
syntax match asemeReference_501 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemeClause_499 /\vas%(<|>)/ contained nextgroup=asemeReference_498,asemeComment_500 skipwhite skipempty
syntax region asemeComment_500 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_498,asemeComment_500 skipwhite skipempty
syntax match asemeComment_500 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_498,asemeComment_500 skipwhite skipempty
syntax match asemeReference_498 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemeClause_496 /\vwith%(<|>)/ contained nextgroup=asemeReference_494,asemeComment_497 skipwhite skipempty
syntax region asemeComment_497 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_494,asemeComment_497 skipwhite skipempty
syntax match asemeComment_497 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_494,asemeComment_497 skipwhite skipempty
syntax match asemeReference_494 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_492,asemeComment_495 skipwhite skipempty
syntax region asemeComment_495 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_492,asemeComment_495 skipwhite skipempty
syntax match asemeComment_495 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_492,asemeComment_495 skipwhite skipempty
syntax match asemeOperator_492 /\v\=%(\=)@!/ contained nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax match asemeReference_490 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax region asemeComment_491 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemeComment_491 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_491 skipwhite skipempty
syntax match asemeDeclaration_488 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_487,asemeComment_489 skipwhite skipempty
syntax region asemeComment_489 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_487,asemeComment_489 skipwhite skipempty
syntax match asemeComment_489 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_487,asemeComment_489 skipwhite skipempty
syntax match asemeReference_487 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_483 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_484,asemeReference_486
syntax match asemeReference_486 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_483 skipwhite skipempty
syntax match asemePunctuation_484 /\v\,/ contained nextgroup=asemeReference_482,asemeComment_485 skipwhite skipempty
syntax region asemeComment_485 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_482,asemeComment_485 skipwhite skipempty
syntax match asemeComment_485 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_482,asemeComment_485 skipwhite skipempty
syntax match asemeReference_482 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_483 skipwhite skipempty
syntax region asemeComment_483 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_483 skipwhite skipempty
syntax match asemeComment_483 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_483 skipwhite skipempty
syntax match asemeClause_480 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_478,asemeComment_481 skipwhite skipempty
syntax region asemeComment_481 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_478,asemeComment_481 skipwhite skipempty
syntax match asemeComment_481 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_478,asemeComment_481 skipwhite skipempty
syntax match asemeBlock_478 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_479 skipwhite skipempty
syntax region asemeComment_479 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_479 skipwhite skipempty
syntax match asemeComment_479 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_479 skipwhite skipempty
syntax match asemeDeclaration_476 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_475,asemeComment_477 skipwhite skipempty
syntax region asemeComment_477 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_475,asemeComment_477 skipwhite skipempty
syntax match asemeComment_477 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_475,asemeComment_477 skipwhite skipempty
syntax match asemeBlock_475 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_474 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_472,asemeBlock_473
syntax match asemeBlock_473 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_474 skipwhite skipempty
syntax region asemeComment_474 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_474 skipwhite skipempty
syntax match asemeComment_474 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_474 skipwhite skipempty
syntax region asemePunctuation_472 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_344,asemeDeclaration_347,asemeDeclaration_375,asemeDeclaration_379,asemeDeclaration_470,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_470 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_468,asemeComment_471 skipwhite skipempty
syntax region asemeComment_471 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_468,asemeComment_471 skipwhite skipempty
syntax match asemeComment_471 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_468,asemeComment_471 skipwhite skipempty
syntax match asemeBlock_468 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_467,@asemeControlInBodyOfAip,asemeComment_469 skipwhite skipempty
syntax region asemeComment_469 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_467,@asemeControlInBodyOfAip,asemeComment_469 skipwhite skipempty
syntax match asemeComment_469 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_467,@asemeControlInBodyOfAip,asemeComment_469 skipwhite skipempty
syntax match asemeOperator_467 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_463 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_461,asemeOperator_462,asemeBlock_465
syntax match asemeBlock_465 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_464,@asemeControlInBodyOfAip,asemeComment_466 skipwhite skipempty
syntax region asemeComment_466 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_464,@asemeControlInBodyOfAip,asemeComment_466 skipwhite skipempty
syntax match asemeComment_466 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_464,@asemeControlInBodyOfAip,asemeComment_466 skipwhite skipempty
syntax match asemeOperator_464 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_463 skipwhite skipempty
syntax match asemeOperator_462 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_463 skipwhite skipempty
syntax region asemeComment_463 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_463 skipwhite skipempty
syntax match asemeComment_463 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_463 skipwhite skipempty
syntax region asemePunctuation_461 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_424,asemeNumber_459,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeNumber_459 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_457,asemeComment_460 skipwhite skipempty
syntax region asemeComment_460 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_457,asemeComment_460 skipwhite skipempty
syntax match asemeComment_460 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_457,asemeComment_460 skipwhite skipempty
syntax match asemeOperator_457 /\v\-\>/ contained nextgroup=asemeNumber_455,asemeComment_458 skipwhite skipempty
syntax region asemeComment_458 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_455,asemeComment_458 skipwhite skipempty
syntax match asemeComment_458 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_455,asemeComment_458 skipwhite skipempty
syntax match asemeNumber_455 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax region asemeComment_456 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax match asemeComment_456 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax match asemePunctuation_454 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeDeclaration_424 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_383,asemeOperator_386,asemePunctuation_417,asemeText_418,asemeNumber_419,asemeReference_420,asemeNumber_421,asemeOperator_422,asemePunctuation_423
syntax match asemePunctuation_423 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeOperator_422 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeNumber_421 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeReference_420 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeNumber_419 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeText_418 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemePunctuation_417 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeOperator_386 /\v\#/ contained nextgroup=asemeNumber_385,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_385,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_385,asemeComment_387 skipwhite skipempty
syntax match asemeNumber_385 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeClause_383 /\vevery%(<|>)/ contained nextgroup=asemeNumber_381,asemeComment_384 skipwhite skipempty
syntax region asemeComment_384 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_381,asemeComment_384 skipwhite skipempty
syntax match asemeComment_384 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_381,asemeComment_384 skipwhite skipempty
syntax match asemeNumber_381 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax region asemeComment_382 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeComment_382 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_382 skipwhite skipempty
syntax match asemeDeclaration_379 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_377,asemeComment_380 skipwhite skipempty
syntax region asemeComment_380 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_377,asemeComment_380 skipwhite skipempty
syntax match asemeComment_380 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_377,asemeComment_380 skipwhite skipempty
syntax match asemeName_377 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_376,asemeComment_378 skipwhite skipempty
syntax region asemeComment_378 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_376,asemeComment_378 skipwhite skipempty
syntax match asemeComment_378 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_376,asemeComment_378 skipwhite skipempty
syntax match asemeOperator_376 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_375 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_354,asemeClause_357,asemeClause_360,asemeClause_363,asemeClause_365,asemeClause_366,asemePunctuation_368,asemeOperator_371,asemePunctuation_373,asemeName_374
syntax match asemeName_374 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemePunctuation_373 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeOperator_371 /\v\@/ contained nextgroup=asemeReference_370,asemeComment_372 skipwhite skipempty
syntax region asemeComment_372 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_370,asemeComment_372 skipwhite skipempty
syntax match asemeComment_372 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_370,asemeComment_372 skipwhite skipempty
syntax match asemeReference_370 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemePunctuation_368 /\v\(/ contained nextgroup=asemeName_367,asemeComment_369 skipwhite skipempty
syntax region asemeComment_369 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_367,asemeComment_369 skipwhite skipempty
syntax match asemeComment_369 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_367,asemeComment_369 skipwhite skipempty
syntax match asemeName_367 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeClause_366 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeClause_365 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeClause_363 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_362,asemeComment_364 skipwhite skipempty
syntax region asemeComment_364 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_362,asemeComment_364 skipwhite skipempty
syntax match asemeComment_364 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_362,asemeComment_364 skipwhite skipempty
syntax match asemeNumber_362 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeClause_360 /\vleads%(<|>)/ contained nextgroup=asemeClause_359,asemeComment_361 skipwhite skipempty
syntax region asemeComment_361 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_359,asemeComment_361 skipwhite skipempty
syntax match asemeComment_361 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_359,asemeComment_361 skipwhite skipempty
syntax match asemeClause_359 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeClause_357 /\vor%(<|>)/ contained nextgroup=asemeName_356,asemeComment_358 skipwhite skipempty
syntax region asemeComment_358 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_356,asemeComment_358 skipwhite skipempty
syntax match asemeComment_358 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_356,asemeComment_358 skipwhite skipempty
syntax match asemeName_356 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeClause_354 /\vat%(<|>)/ contained nextgroup=asemeClause_352,asemeComment_355 skipwhite skipempty
syntax region asemeComment_355 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_352,asemeComment_355 skipwhite skipempty
syntax match asemeComment_355 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_352,asemeComment_355 skipwhite skipempty
syntax match asemeClause_352 /\vmost%(<|>)/ contained nextgroup=asemeChoice_349,asemeNumber_351,asemeComment_353 skipwhite skipempty
syntax region asemeComment_353 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_349,asemeNumber_351,asemeComment_353 skipwhite skipempty
syntax match asemeComment_353 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_349,asemeNumber_351,asemeComment_353 skipwhite skipempty
syntax match asemeNumber_351 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeChoice_349 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax region asemeComment_350 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeComment_350 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_350 skipwhite skipempty
syntax match asemeDeclaration_347 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_346,asemeComment_348 skipwhite skipempty
syntax region asemeComment_348 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_346,asemeComment_348 skipwhite skipempty
syntax match asemeComment_348 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_346,asemeComment_348 skipwhite skipempty
syntax match asemeText_346 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_344 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_343,asemeComment_345 skipwhite skipempty
syntax region asemeComment_345 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_343,asemeComment_345 skipwhite skipempty
syntax match asemeComment_345 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_343,asemeComment_345 skipwhite skipempty
syntax match asemeBlock_343 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_220,asemePunctuation_223,asemePunctuation_225,asemePunctuation_341,asemeBlock_342
syntax match asemeBlock_342 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_219 skipwhite skipempty
syntax region asemePunctuation_341 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_227,asemeDeclaration_278,asemeDeclaration_283,asemeDeclaration_304,asemeDeclaration_318,asemeName_340,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_340 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_322,asemePunctuation_326,asemePunctuation_329,asemePunctuation_331,asemeOperator_339
syntax match asemeOperator_339 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemePunctuation_331 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax match asemePunctuation_329 /\v\,/ contained nextgroup=asemeName_328,asemeComment_330 skipwhite skipempty
syntax region asemeComment_330 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_328,asemeComment_330 skipwhite skipempty
syntax match asemeComment_330 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_328,asemeComment_330 skipwhite skipempty
syntax match asemeName_328 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax match asemePunctuation_326 /\v\:/ contained nextgroup=asemeBuiltIn_324,asemeType_325,asemeComment_327 skipwhite skipempty
syntax region asemeComment_327 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_324,asemeType_325,asemeComment_327 skipwhite skipempty
syntax match asemeComment_327 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_324,asemeType_325,asemeComment_327 skipwhite skipempty
syntax match asemeType_325 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax match asemeBuiltIn_324 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax match asemePunctuation_322 /\v\(/ contained nextgroup=asemeName_320,asemeComment_323 skipwhite skipempty
syntax region asemeComment_323 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_320,asemeComment_323 skipwhite skipempty
syntax match asemeComment_323 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_320,asemeComment_323 skipwhite skipempty
syntax match asemeName_320 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax region asemeComment_321 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax match asemeComment_321 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_321 skipwhite skipempty
syntax match asemeDeclaration_318 /\v%(receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_316,asemeComment_319 skipwhite skipempty
syntax region asemeComment_319 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_316,asemeComment_319 skipwhite skipempty
syntax match asemeComment_319 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_316,asemeComment_319 skipwhite skipempty
syntax match asemeReference_316 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_315,asemeComment_317 skipwhite skipempty
syntax region asemeComment_317 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_315,asemeComment_317 skipwhite skipempty
syntax match asemeComment_317 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_315,asemeComment_317 skipwhite skipempty
syntax match asemeReference_315 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_310,asemeReference_313
syntax match asemeReference_313 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_312,@asemeReceivesInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax region asemeComment_314 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_312,@asemeReceivesInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemeComment_314 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_312,@asemeReceivesInBodyOfParticipant,asemeComment_314 skipwhite skipempty
syntax match asemeReference_312 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemePunctuation_310 /\v\,/ contained nextgroup=asemeReference_308,asemeComment_311 skipwhite skipempty
syntax region asemeComment_311 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_308,asemeComment_311 skipwhite skipempty
syntax match asemeComment_311 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_308,asemeComment_311 skipwhite skipempty
syntax match asemeReference_308 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_306,asemeComment_309 skipwhite skipempty
syntax region asemeComment_309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_306,asemeComment_309 skipwhite skipempty
syntax match asemeComment_309 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_306,asemeComment_309 skipwhite skipempty
syntax match asemeReference_306 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax region asemeComment_307 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemeComment_307 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemeDeclaration_304 /\v%(sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_302,asemeComment_305 skipwhite skipempty
syntax region asemeComment_305 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_302,asemeComment_305 skipwhite skipempty
syntax match asemeComment_305 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_302,asemeComment_305 skipwhite skipempty
syntax match asemeReference_302 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_301,asemeComment_303 skipwhite skipempty
syntax region asemeComment_303 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_301,asemeComment_303 skipwhite skipempty
syntax match asemeComment_303 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_301,asemeComment_303 skipwhite skipempty
syntax match asemeReference_301 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_287,asemeClause_290,asemeClause_292,asemePunctuation_296,asemeReference_299
syntax match asemeReference_299 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_298,@asemeSendsInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax region asemeComment_300 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_298,@asemeSendsInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax match asemeComment_300 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_298,@asemeSendsInBodyOfParticipant,asemeComment_300 skipwhite skipempty
syntax match asemeReference_298 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemePunctuation_296 /\v\,/ contained nextgroup=asemeReference_294,asemeComment_297 skipwhite skipempty
syntax region asemeComment_297 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_294,asemeComment_297 skipwhite skipempty
syntax match asemeComment_297 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_294,asemeComment_297 skipwhite skipempty
syntax match asemeReference_294 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_293,asemeComment_295 skipwhite skipempty
syntax region asemeComment_295 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_293,asemeComment_295 skipwhite skipempty
syntax match asemeComment_295 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_293,asemeComment_295 skipwhite skipempty
syntax match asemeReference_293 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemeClause_292 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemeClause_290 /\vor%(<|>)/ contained nextgroup=asemeReference_289,asemeComment_291 skipwhite skipempty
syntax region asemeComment_291 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_289,asemeComment_291 skipwhite skipempty
syntax match asemeComment_291 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_289,asemeComment_291 skipwhite skipempty
syntax match asemeReference_289 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
syntax match asemeClause_287 /\vby%(<|>)/ contained nextgroup=asemeReference_285,asemeComment_288 skipwhite skipempty
syntax region asemeComment_288 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_285,asemeComment_288 skipwhite skipempty
syntax match asemeComment_288 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_285,asemeComment_288 skipwhite skipempty
syntax match asemeReference_285 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_286 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_894,asemeClause_897,asemeText_899,asemeNumber_900,asemeTruth_901,asemeLogic_902,asemeClause_903,asemeClause_904,asemeClause_905,asemeClause_906,asemeClause_907,asemeClause_908,asemeClause_909,asemeClause_910,asemeClause_911,asemeClause_912,asemeCall_913,asemeReference_914,asemeOperator_915,asemePunctuation_916
syntax match asemePunctuation_916 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeOperator_915 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeReference_914 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeCall_913 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_912 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_911 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_910 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_909 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_908 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_907 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_906 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_905 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_904 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_903 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeLogic_902 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeTruth_901 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeNumber_900 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeText_899 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeClause_897 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_896,asemeComment_898 skipwhite skipempty
syntax region asemeComment_898 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_896,asemeComment_898 skipwhite skipempty
syntax match asemeComment_898 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_896,asemeComment_898 skipwhite skipempty
syntax match asemeReference_896 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_889,asemeComment_891 skipwhite skipempty
syntax match asemeClause_894 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_892,asemeComment_895 skipwhite skipempty
syntax region asemeComment_895 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_892,asemeComment_895 skipwhite skipempty
syntax match asemeComment_895 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_892,asemeComment_895 skipwhite skipempty
syntax match asemeReference_892 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_890,asemeComment_893 skipwhite skipempty
syntax region asemeComment_893 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_890,asemeComment_893 skipwhite skipempty
syntax match asemeComment_893 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_890,asemeComment_893 skipwhite skipempty
syntax match asemeReference_890 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_889,asemeComment_891 skipwhite skipempty
syntax region asemeComment_891 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_889,asemeComment_891 skipwhite skipempty
syntax match asemeComment_891 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_889,asemeComment_891 skipwhite skipempty
syntax region asemePunctuation_889 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax region asemeComment_888 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax match asemeComment_888 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_888 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_833,asemeClause_836,asemeText_838,asemeNumber_839,asemeTruth_840,asemeLogic_841,asemeClause_842,asemeClause_843,asemeClause_844,asemeClause_845,asemeClause_846,asemeClause_847,asemeClause_848,asemeClause_849,asemeClause_850,asemeClause_851,asemeCall_852,asemeReference_853,asemeOperator_854,asemePunctuation_855
syntax match asemePunctuation_855 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeOperator_854 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeReference_853 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeCall_852 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_851 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_850 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_849 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_848 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_847 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_846 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_845 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_844 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_843 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_842 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeLogic_841 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeTruth_840 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeNumber_839 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeText_838 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeClause_836 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_835,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_835,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_835,asemeComment_837 skipwhite skipempty
syntax match asemeReference_835 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_828,asemeComment_830 skipwhite skipempty
syntax match asemeClause_833 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_831,asemeComment_834 skipwhite skipempty
syntax region asemeComment_834 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_831,asemeComment_834 skipwhite skipempty
syntax match asemeComment_834 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_831,asemeComment_834 skipwhite skipempty
syntax match asemeReference_831 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_829,asemeComment_832 skipwhite skipempty
syntax region asemeComment_832 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_829,asemeComment_832 skipwhite skipempty
syntax match asemeComment_832 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_829,asemeComment_832 skipwhite skipempty
syntax match asemeReference_829 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_828,asemeComment_830 skipwhite skipempty
syntax region asemeComment_830 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_828,asemeComment_830 skipwhite skipempty
syntax match asemeComment_830 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_828,asemeComment_830 skipwhite skipempty
syntax region asemePunctuation_828 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax region asemeComment_827 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax match asemeComment_827 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_827 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_794,asemeClause_797,asemeText_799,asemeNumber_800,asemeTruth_801,asemeLogic_802,asemeClause_803,asemeClause_804,asemeClause_805,asemeClause_806,asemeClause_807,asemeClause_808,asemeClause_809,asemeClause_810,asemeClause_811,asemeClause_812,asemeCall_813,asemeReference_814,asemeOperator_815,asemePunctuation_816
syntax match asemePunctuation_816 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeOperator_815 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeReference_814 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeCall_813 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_812 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_811 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_810 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_809 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_808 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_807 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_806 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_805 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_804 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_803 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeLogic_802 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeTruth_801 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeNumber_800 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeText_799 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeClause_797 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_796,asemeComment_798 skipwhite skipempty
syntax region asemeComment_798 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_796,asemeComment_798 skipwhite skipempty
syntax match asemeComment_798 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_796,asemeComment_798 skipwhite skipempty
syntax match asemeReference_796 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_789,asemeComment_791 skipwhite skipempty
syntax match asemeClause_794 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_792,asemeComment_795 skipwhite skipempty
syntax region asemeComment_795 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_792,asemeComment_795 skipwhite skipempty
syntax match asemeComment_795 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_792,asemeComment_795 skipwhite skipempty
syntax match asemeReference_792 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_790,asemeComment_793 skipwhite skipempty
syntax region asemeComment_793 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_790,asemeComment_793 skipwhite skipempty
syntax match asemeComment_793 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_790,asemeComment_793 skipwhite skipempty
syntax match asemeReference_790 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_789,asemeComment_791 skipwhite skipempty
syntax region asemeComment_791 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_789,asemeComment_791 skipwhite skipempty
syntax match asemeComment_791 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_789,asemeComment_791 skipwhite skipempty
syntax region asemePunctuation_789 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax region asemeComment_788 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax match asemeComment_788 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_788 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_610,asemeNumber_612,asemeReference_613,asemeNumber_614,asemeOperator_615,asemePunctuation_616
syntax match asemePunctuation_616 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeOperator_615 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeNumber_614 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeReference_613 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeNumber_612 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeText_610 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax region asemeComment_611 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeComment_611 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_553,asemeClause_556,asemeText_558,asemeNumber_559,asemeTruth_560,asemeLogic_561,asemeClause_562,asemeClause_563,asemeClause_564,asemeClause_565,asemeClause_566,asemeClause_567,asemeClause_568,asemeClause_569,asemeClause_570,asemeClause_571,asemeCall_572,asemeReference_573,asemeOperator_574,asemePunctuation_575
syntax match asemePunctuation_575 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeOperator_574 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeReference_573 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeCall_572 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_571 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_570 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_569 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_568 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_567 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_566 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_565 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_564 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_563 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_562 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeLogic_561 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeTruth_560 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeNumber_559 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeText_558 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeClause_556 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_555,asemeComment_557 skipwhite skipempty
syntax region asemeComment_557 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_555,asemeComment_557 skipwhite skipempty
syntax match asemeComment_557 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_555,asemeComment_557 skipwhite skipempty
syntax match asemeReference_555 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_548,asemeComment_550 skipwhite skipempty
syntax match asemeClause_553 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_551,asemeComment_554 skipwhite skipempty
syntax region asemeComment_554 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_551,asemeComment_554 skipwhite skipempty
syntax match asemeComment_554 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_551,asemeComment_554 skipwhite skipempty
syntax match asemeReference_551 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_549,asemeComment_552 skipwhite skipempty
syntax region asemeComment_552 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_549,asemeComment_552 skipwhite skipempty
syntax match asemeComment_552 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_549,asemeComment_552 skipwhite skipempty
syntax match asemeReference_549 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_548,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_548,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_548,asemeComment_550 skipwhite skipempty
syntax region asemePunctuation_548 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_547 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_431,asemeClause_434,asemeText_436,asemeNumber_437,asemeTruth_438,asemeLogic_439,asemeClause_440,asemeClause_441,asemeClause_442,asemeClause_443,asemeClause_444,asemeClause_445,asemeClause_446,asemeClause_447,asemeClause_448,asemeClause_449,asemeCall_450,asemeReference_451,asemeOperator_452,asemePunctuation_453
syntax match asemePunctuation_453 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeOperator_452 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeReference_451 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeCall_450 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_449 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_448 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_447 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_446 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_445 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_444 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_443 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_442 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_441 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_440 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeLogic_439 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeTruth_438 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeNumber_437 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeText_436 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeClause_434 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_433,asemeComment_435 skipwhite skipempty
syntax region asemeComment_435 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_433,asemeComment_435 skipwhite skipempty
syntax match asemeComment_435 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_433,asemeComment_435 skipwhite skipempty
syntax match asemeReference_433 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_426,asemeComment_428 skipwhite skipempty
syntax match asemeClause_431 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_429,asemeComment_432 skipwhite skipempty
syntax region asemeComment_432 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_429,asemeComment_432 skipwhite skipempty
syntax match asemeComment_432 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_429,asemeComment_432 skipwhite skipempty
syntax match asemeReference_429 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_427,asemeComment_430 skipwhite skipempty
syntax region asemeComment_430 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_427,asemeComment_430 skipwhite skipempty
syntax match asemeComment_430 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_427,asemeComment_430 skipwhite skipempty
syntax match asemeReference_427 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_426,asemeComment_428 skipwhite skipempty
syntax region asemeComment_428 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_426,asemeComment_428 skipwhite skipempty
syntax match asemeComment_428 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_426,asemeComment_428 skipwhite skipempty
syntax region asemePunctuation_426 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax region asemeComment_425 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax match asemeComment_425 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_425 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_394,asemeClause_397,asemeText_399,asemeNumber_400,asemeTruth_401,asemeLogic_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeClause_406,asemeClause_407,asemeClause_408,asemeClause_409,asemeClause_410,asemeClause_411,asemeClause_412,asemeCall_413,asemeReference_414,asemeOperator_415,asemePunctuation_416
syntax match asemePunctuation_416 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeOperator_415 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeReference_414 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeCall_413 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_412 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_411 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_410 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_409 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_408 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_407 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_406 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeLogic_402 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeTruth_401 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeNumber_400 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeText_399 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeClause_397 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_396,asemeComment_398 skipwhite skipempty
syntax region asemeComment_398 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_396,asemeComment_398 skipwhite skipempty
syntax match asemeComment_398 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_396,asemeComment_398 skipwhite skipempty
syntax match asemeReference_396 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_389,asemeComment_391 skipwhite skipempty
syntax match asemeClause_394 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_392,asemeComment_395 skipwhite skipempty
syntax region asemeComment_395 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_392,asemeComment_395 skipwhite skipempty
syntax match asemeComment_395 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_392,asemeComment_395 skipwhite skipempty
syntax match asemeReference_392 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_390,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_390,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_390,asemeComment_393 skipwhite skipempty
syntax match asemeReference_390 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_389,asemeComment_391 skipwhite skipempty
syntax region asemeComment_391 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_389,asemeComment_391 skipwhite skipempty
syntax match asemeComment_391 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_389,asemeComment_391 skipwhite skipempty
syntax region asemePunctuation_389 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax region asemeComment_388 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax match asemeComment_388 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_388 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_332,asemeNumber_334,asemeReference_335,asemeNumber_336,asemeOperator_337,asemePunctuation_338
syntax match asemePunctuation_338 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemeOperator_337 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemeNumber_336 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemeReference_335 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemeNumber_334 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemeText_332 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax region asemeComment_333 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
syntax match asemeComment_333 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_333 skipwhite skipempty
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
highlight default link asemeBlock_342 asemeBlock
highlight default link asemeBlock_343 asemeBlock
highlight default link asemeBlock_465 asemeBlock
highlight default link asemeBlock_468 asemeBlock
highlight default link asemeBlock_473 asemeBlock
highlight default link asemeBlock_475 asemeBlock
highlight default link asemeBlock_478 asemeBlock
highlight default link asemeBlock_732 asemeBlock
highlight default link asemeBlock_734 asemeBlock
highlight default link asemeBlock_740 asemeBlock
highlight default link asemeBlock_743 asemeBlock
highlight default link asemeBlock_748 asemeBlock
highlight default link asemeBlock_749 asemeBlock
highlight default link asemeBlock_75 asemeBlock
highlight default link asemeBlock_754 asemeBlock
highlight default link asemeBlock_77 asemeBlock
highlight default link asemeBlock_883 asemeBlock
highlight default link asemeBlock_885 asemeBlock
highlight default link asemeBlock_943 asemeBlock
highlight default link asemeBlock_945 asemeBlock
highlight default link asemeBuiltIn_137 asemeBuiltIn
highlight default link asemeBuiltIn_145 asemeBuiltIn
highlight default link asemeBuiltIn_152 asemeBuiltIn
highlight default link asemeBuiltIn_229 asemeBuiltIn
highlight default link asemeBuiltIn_264 asemeBuiltIn
highlight default link asemeBuiltIn_270 asemeBuiltIn
highlight default link asemeBuiltIn_272 asemeBuiltIn
highlight default link asemeBuiltIn_324 asemeBuiltIn
highlight default link asemeBuiltIn_542 asemeBuiltIn
highlight default link asemeBuiltIn_577 asemeBuiltIn
highlight default link asemeBuiltIn_583 asemeBuiltIn
highlight default link asemeBuiltIn_585 asemeBuiltIn
highlight default link asemeBuiltIn_602 asemeBuiltIn
highlight default link asemeBuiltIn_654 asemeBuiltIn
highlight default link asemeBuiltIn_662 asemeBuiltIn
highlight default link asemeBuiltIn_822 asemeBuiltIn
highlight default link asemeBuiltIn_857 asemeBuiltIn
highlight default link asemeBuiltIn_86 asemeBuiltIn
highlight default link asemeBuiltIn_863 asemeBuiltIn
highlight default link asemeBuiltIn_865 asemeBuiltIn
highlight default link asemeBuiltIn_91 asemeBuiltIn
highlight default link asemeBuiltIn_97 asemeBuiltIn
highlight default link asemeCall_24 asemeCall
highlight default link asemeCall_259 asemeCall
highlight default link asemeCall_413 asemeCall
highlight default link asemeCall_450 asemeCall
highlight default link asemeCall_572 asemeCall
highlight default link asemeCall_59 asemeCall
highlight default link asemeCall_813 asemeCall
highlight default link asemeCall_852 asemeCall
highlight default link asemeCall_913 asemeCall
highlight default link asemeChoice_120 asemeChoice
highlight default link asemeChoice_190 asemeChoice
highlight default link asemeChoice_349 asemeChoice
highlight default link asemeChoice_624 asemeChoice
highlight default link asemeChoice_638 asemeChoice
highlight default link asemeChoice_669 asemeChoice
highlight default link asemeChoice_683 asemeChoice
highlight default link asemeChoice_697 asemeChoice
highlight default link asemeChoice_714 asemeChoice
highlight default link asemeChoice_763 asemeChoice
highlight default link asemeChoice_767 asemeChoice
highlight default link asemeChoice_775 asemeChoice
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
highlight default link asemeClause_287 asemeClause
highlight default link asemeClause_290 asemeClause
highlight default link asemeClause_292 asemeClause
highlight default link asemeClause_352 asemeClause
highlight default link asemeClause_354 asemeClause
highlight default link asemeClause_357 asemeClause
highlight default link asemeClause_359 asemeClause
highlight default link asemeClause_360 asemeClause
highlight default link asemeClause_363 asemeClause
highlight default link asemeClause_365 asemeClause
highlight default link asemeClause_366 asemeClause
highlight default link asemeClause_383 asemeClause
highlight default link asemeClause_394 asemeClause
highlight default link asemeClause_397 asemeClause
highlight default link asemeClause_40 asemeClause
highlight default link asemeClause_403 asemeClause
highlight default link asemeClause_404 asemeClause
highlight default link asemeClause_405 asemeClause
highlight default link asemeClause_406 asemeClause
highlight default link asemeClause_407 asemeClause
highlight default link asemeClause_408 asemeClause
highlight default link asemeClause_409 asemeClause
highlight default link asemeClause_410 asemeClause
highlight default link asemeClause_411 asemeClause
highlight default link asemeClause_412 asemeClause
highlight default link asemeClause_43 asemeClause
highlight default link asemeClause_431 asemeClause
highlight default link asemeClause_434 asemeClause
highlight default link asemeClause_440 asemeClause
highlight default link asemeClause_441 asemeClause
highlight default link asemeClause_442 asemeClause
highlight default link asemeClause_443 asemeClause
highlight default link asemeClause_444 asemeClause
highlight default link asemeClause_445 asemeClause
highlight default link asemeClause_446 asemeClause
highlight default link asemeClause_447 asemeClause
highlight default link asemeClause_448 asemeClause
highlight default link asemeClause_449 asemeClause
highlight default link asemeClause_480 asemeClause
highlight default link asemeClause_49 asemeClause
highlight default link asemeClause_496 asemeClause
highlight default link asemeClause_499 asemeClause
highlight default link asemeClause_50 asemeClause
highlight default link asemeClause_51 asemeClause
highlight default link asemeClause_52 asemeClause
highlight default link asemeClause_53 asemeClause
highlight default link asemeClause_54 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_553 asemeClause
highlight default link asemeClause_556 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_562 asemeClause
highlight default link asemeClause_563 asemeClause
highlight default link asemeClause_564 asemeClause
highlight default link asemeClause_565 asemeClause
highlight default link asemeClause_566 asemeClause
highlight default link asemeClause_567 asemeClause
highlight default link asemeClause_568 asemeClause
highlight default link asemeClause_569 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_570 asemeClause
highlight default link asemeClause_571 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_627 asemeClause
highlight default link asemeClause_630 asemeClause
highlight default link asemeClause_633 asemeClause
highlight default link asemeClause_636 asemeClause
highlight default link asemeClause_639 asemeClause
highlight default link asemeClause_642 asemeClause
highlight default link asemeClause_645 asemeClause
highlight default link asemeClause_648 asemeClause
highlight default link asemeClause_651 asemeClause
highlight default link asemeClause_653 asemeClause
highlight default link asemeClause_686 asemeClause
highlight default link asemeClause_689 asemeClause
highlight default link asemeClause_692 asemeClause
highlight default link asemeClause_695 asemeClause
highlight default link asemeClause_698 asemeClause
highlight default link asemeClause_701 asemeClause
highlight default link asemeClause_704 asemeClause
highlight default link asemeClause_707 asemeClause
highlight default link asemeClause_710 asemeClause
highlight default link asemeClause_712 asemeClause
highlight default link asemeClause_750 asemeClause
highlight default link asemeClause_759 asemeClause
highlight default link asemeClause_794 asemeClause
highlight default link asemeClause_797 asemeClause
highlight default link asemeClause_803 asemeClause
highlight default link asemeClause_804 asemeClause
highlight default link asemeClause_805 asemeClause
highlight default link asemeClause_806 asemeClause
highlight default link asemeClause_807 asemeClause
highlight default link asemeClause_808 asemeClause
highlight default link asemeClause_809 asemeClause
highlight default link asemeClause_810 asemeClause
highlight default link asemeClause_811 asemeClause
highlight default link asemeClause_812 asemeClause
highlight default link asemeClause_833 asemeClause
highlight default link asemeClause_836 asemeClause
highlight default link asemeClause_842 asemeClause
highlight default link asemeClause_843 asemeClause
highlight default link asemeClause_844 asemeClause
highlight default link asemeClause_845 asemeClause
highlight default link asemeClause_846 asemeClause
highlight default link asemeClause_847 asemeClause
highlight default link asemeClause_848 asemeClause
highlight default link asemeClause_849 asemeClause
highlight default link asemeClause_850 asemeClause
highlight default link asemeClause_851 asemeClause
highlight default link asemeClause_894 asemeClause
highlight default link asemeClause_897 asemeClause
highlight default link asemeClause_903 asemeClause
highlight default link asemeClause_904 asemeClause
highlight default link asemeClause_905 asemeClause
highlight default link asemeClause_906 asemeClause
highlight default link asemeClause_907 asemeClause
highlight default link asemeClause_908 asemeClause
highlight default link asemeClause_909 asemeClause
highlight default link asemeClause_910 asemeClause
highlight default link asemeClause_911 asemeClause
highlight default link asemeClause_912 asemeClause
highlight default link asemeClause_920 asemeClause
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
highlight default link asemeComment_291 asemeComment
highlight default link asemeComment_295 asemeComment
highlight default link asemeComment_297 asemeComment
highlight default link asemeComment_300 asemeComment
highlight default link asemeComment_303 asemeComment
highlight default link asemeComment_305 asemeComment
highlight default link asemeComment_307 asemeComment
highlight default link asemeComment_309 asemeComment
highlight default link asemeComment_311 asemeComment
highlight default link asemeComment_314 asemeComment
highlight default link asemeComment_317 asemeComment
highlight default link asemeComment_319 asemeComment
highlight default link asemeComment_321 asemeComment
highlight default link asemeComment_323 asemeComment
highlight default link asemeComment_327 asemeComment
highlight default link asemeComment_330 asemeComment
highlight default link asemeComment_333 asemeComment
highlight default link asemeComment_34 asemeComment
highlight default link asemeComment_345 asemeComment
highlight default link asemeComment_348 asemeComment
highlight default link asemeComment_350 asemeComment
highlight default link asemeComment_353 asemeComment
highlight default link asemeComment_355 asemeComment
highlight default link asemeComment_358 asemeComment
highlight default link asemeComment_361 asemeComment
highlight default link asemeComment_364 asemeComment
highlight default link asemeComment_369 asemeComment
highlight default link asemeComment_37 asemeComment
highlight default link asemeComment_372 asemeComment
highlight default link asemeComment_378 asemeComment
highlight default link asemeComment_380 asemeComment
highlight default link asemeComment_382 asemeComment
highlight default link asemeComment_384 asemeComment
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_388 asemeComment
highlight default link asemeComment_39 asemeComment
highlight default link asemeComment_391 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_395 asemeComment
highlight default link asemeComment_398 asemeComment
highlight default link asemeComment_41 asemeComment
highlight default link asemeComment_425 asemeComment
highlight default link asemeComment_428 asemeComment
highlight default link asemeComment_430 asemeComment
highlight default link asemeComment_432 asemeComment
highlight default link asemeComment_435 asemeComment
highlight default link asemeComment_44 asemeComment
highlight default link asemeComment_456 asemeComment
highlight default link asemeComment_458 asemeComment
highlight default link asemeComment_460 asemeComment
highlight default link asemeComment_463 asemeComment
highlight default link asemeComment_466 asemeComment
highlight default link asemeComment_469 asemeComment
highlight default link asemeComment_471 asemeComment
highlight default link asemeComment_474 asemeComment
highlight default link asemeComment_477 asemeComment
highlight default link asemeComment_479 asemeComment
highlight default link asemeComment_481 asemeComment
highlight default link asemeComment_483 asemeComment
highlight default link asemeComment_485 asemeComment
highlight default link asemeComment_489 asemeComment
highlight default link asemeComment_491 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_495 asemeComment
highlight default link asemeComment_497 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_500 asemeComment
highlight default link asemeComment_503 asemeComment
highlight default link asemeComment_506 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_510 asemeComment
highlight default link asemeComment_513 asemeComment
highlight default link asemeComment_516 asemeComment
highlight default link asemeComment_518 asemeComment
highlight default link asemeComment_521 asemeComment
highlight default link asemeComment_523 asemeComment
highlight default link asemeComment_525 asemeComment
highlight default link asemeComment_527 asemeComment
highlight default link asemeComment_529 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_536 asemeComment
highlight default link asemeComment_539 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_543 asemeComment
highlight default link asemeComment_546 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_550 asemeComment
highlight default link asemeComment_552 asemeComment
highlight default link asemeComment_554 asemeComment
highlight default link asemeComment_557 asemeComment
highlight default link asemeComment_580 asemeComment
highlight default link asemeComment_582 asemeComment
highlight default link asemeComment_588 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_595 asemeComment
highlight default link asemeComment_597 asemeComment
highlight default link asemeComment_599 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_605 asemeComment
highlight default link asemeComment_608 asemeComment
highlight default link asemeComment_611 asemeComment
highlight default link asemeComment_621 asemeComment
highlight default link asemeComment_623 asemeComment
highlight default link asemeComment_625 asemeComment
highlight default link asemeComment_628 asemeComment
highlight default link asemeComment_631 asemeComment
highlight default link asemeComment_634 asemeComment
highlight default link asemeComment_637 asemeComment
highlight default link asemeComment_640 asemeComment
highlight default link asemeComment_643 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_649 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_657 asemeComment
highlight default link asemeComment_659 asemeComment
highlight default link asemeComment_661 asemeComment
highlight default link asemeComment_665 asemeComment
highlight default link asemeComment_667 asemeComment
highlight default link asemeComment_67 asemeComment
highlight default link asemeComment_670 asemeComment
highlight default link asemeComment_675 asemeComment
highlight default link asemeComment_680 asemeComment
highlight default link asemeComment_682 asemeComment
highlight default link asemeComment_684 asemeComment
highlight default link asemeComment_687 asemeComment
highlight default link asemeComment_69 asemeComment
highlight default link asemeComment_690 asemeComment
highlight default link asemeComment_693 asemeComment
highlight default link asemeComment_696 asemeComment
highlight default link asemeComment_699 asemeComment
highlight default link asemeComment_702 asemeComment
highlight default link asemeComment_705 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_71 asemeComment
highlight default link asemeComment_711 asemeComment
highlight default link asemeComment_715 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_723 asemeComment
highlight default link asemeComment_727 asemeComment
highlight default link asemeComment_730 asemeComment
highlight default link asemeComment_733 asemeComment
highlight default link asemeComment_736 asemeComment
highlight default link asemeComment_738 asemeComment
highlight default link asemeComment_741 asemeComment
highlight default link asemeComment_744 asemeComment
highlight default link asemeComment_746 asemeComment
highlight default link asemeComment_751 asemeComment
highlight default link asemeComment_753 asemeComment
highlight default link asemeComment_756 asemeComment
highlight default link asemeComment_758 asemeComment
highlight default link asemeComment_76 asemeComment
highlight default link asemeComment_760 asemeComment
highlight default link asemeComment_764 asemeComment
highlight default link asemeComment_768 asemeComment
highlight default link asemeComment_770 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_778 asemeComment
highlight default link asemeComment_780 asemeComment
highlight default link asemeComment_783 asemeComment
highlight default link asemeComment_785 asemeComment
highlight default link asemeComment_787 asemeComment
highlight default link asemeComment_788 asemeComment
highlight default link asemeComment_79 asemeComment
highlight default link asemeComment_791 asemeComment
highlight default link asemeComment_793 asemeComment
highlight default link asemeComment_795 asemeComment
highlight default link asemeComment_798 asemeComment
highlight default link asemeComment_81 asemeComment
highlight default link asemeComment_819 asemeComment
highlight default link asemeComment_821 asemeComment
highlight default link asemeComment_823 asemeComment
highlight default link asemeComment_826 asemeComment
highlight default link asemeComment_827 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_830 asemeComment
highlight default link asemeComment_832 asemeComment
highlight default link asemeComment_834 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_860 asemeComment
highlight default link asemeComment_862 asemeComment
highlight default link asemeComment_868 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_870 asemeComment
highlight default link asemeComment_872 asemeComment
highlight default link asemeComment_875 asemeComment
highlight default link asemeComment_877 asemeComment
highlight default link asemeComment_879 asemeComment
highlight default link asemeComment_881 asemeComment
highlight default link asemeComment_884 asemeComment
highlight default link asemeComment_887 asemeComment
highlight default link asemeComment_888 asemeComment
highlight default link asemeComment_891 asemeComment
highlight default link asemeComment_893 asemeComment
highlight default link asemeComment_895 asemeComment
highlight default link asemeComment_898 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_919 asemeComment
highlight default link asemeComment_92 asemeComment
highlight default link asemeComment_921 asemeComment
highlight default link asemeComment_923 asemeComment
highlight default link asemeComment_925 asemeComment
highlight default link asemeComment_927 asemeComment
highlight default link asemeComment_929 asemeComment
highlight default link asemeComment_931 asemeComment
highlight default link asemeComment_934 asemeComment
highlight default link asemeComment_937 asemeComment
highlight default link asemeComment_940 asemeComment
highlight default link asemeComment_944 asemeComment
highlight default link asemeComment_947 asemeComment
highlight default link asemeComment_95 asemeComment
highlight default link asemeComment_973 asemeComment
highlight default link asemeComment_976 asemeComment
highlight default link asemeComment_98 asemeComment
highlight default link asemeComment_984 asemeComment
highlight default link asemeComment_987 asemeComment
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
highlight default link asemeDeclaration_304 asemeDeclaration
highlight default link asemeDeclaration_318 asemeDeclaration
highlight default link asemeDeclaration_344 asemeDeclaration
highlight default link asemeDeclaration_347 asemeDeclaration
highlight default link asemeDeclaration_375 asemeDeclaration
highlight default link asemeDeclaration_379 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_424 asemeDeclaration
highlight default link asemeDeclaration_470 asemeDeclaration
highlight default link asemeDeclaration_476 asemeDeclaration
highlight default link asemeDeclaration_488 asemeDeclaration
highlight default link asemeDeclaration_524 asemeDeclaration
highlight default link asemeDeclaration_540 asemeDeclaration
highlight default link asemeDeclaration_591 asemeDeclaration
highlight default link asemeDeclaration_596 asemeDeclaration
highlight default link asemeDeclaration_620 asemeDeclaration
highlight default link asemeDeclaration_66 asemeDeclaration
highlight default link asemeDeclaration_679 asemeDeclaration
highlight default link asemeDeclaration_726 asemeDeclaration
highlight default link asemeDeclaration_729 asemeDeclaration
highlight default link asemeDeclaration_735 asemeDeclaration
highlight default link asemeDeclaration_745 asemeDeclaration
highlight default link asemeDeclaration_752 asemeDeclaration
highlight default link asemeDeclaration_755 asemeDeclaration
highlight default link asemeDeclaration_779 asemeDeclaration
highlight default link asemeDeclaration_78 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_820 asemeDeclaration
highlight default link asemeDeclaration_871 asemeDeclaration
highlight default link asemeDeclaration_876 asemeDeclaration
highlight default link asemeDeclaration_878 asemeDeclaration
highlight default link asemeDeclaration_880 asemeDeclaration
highlight default link asemeDeclaration_886 asemeDeclaration
highlight default link asemeDeclaration_94 asemeDeclaration
highlight default link asemeDeclaration_946 asemeDeclaration
highlight default link asemeDeclaration_975 asemeDeclaration
highlight default link asemeDeclaration_986 asemeDeclaration
highlight default link asemeLogic_13 asemeLogic
highlight default link asemeLogic_248 asemeLogic
highlight default link asemeLogic_402 asemeLogic
highlight default link asemeLogic_439 asemeLogic
highlight default link asemeLogic_48 asemeLogic
highlight default link asemeLogic_561 asemeLogic
highlight default link asemeLogic_802 asemeLogic
highlight default link asemeLogic_841 asemeLogic
highlight default link asemeLogic_902 asemeLogic
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
highlight default link asemeName_320 asemeName
highlight default link asemeName_328 asemeName
highlight default link asemeName_340 asemeName
highlight default link asemeName_356 asemeName
highlight default link asemeName_367 asemeName
highlight default link asemeName_374 asemeName
highlight default link asemeName_377 asemeName
highlight default link asemeName_535 asemeName
highlight default link asemeName_538 asemeName
highlight default link asemeName_581 asemeName
highlight default link asemeName_589 asemeName
highlight default link asemeName_594 asemeName
highlight default link asemeName_598 asemeName
highlight default link asemeName_606 asemeName
highlight default link asemeName_618 asemeName
highlight default link asemeName_64 asemeName
highlight default link asemeName_658 asemeName
highlight default link asemeName_666 asemeName
highlight default link asemeName_677 asemeName
highlight default link asemeName_724 asemeName
highlight default link asemeName_73 asemeName
highlight default link asemeName_761 asemeName
highlight default link asemeName_765 asemeName
highlight default link asemeName_771 asemeName
highlight default link asemeName_773 asemeName
highlight default link asemeName_85 asemeName
highlight default link asemeName_861 asemeName
highlight default link asemeName_869 asemeName
highlight default link asemeName_874 asemeName
highlight default link asemeName_89 asemeName
highlight default link asemeName_90 asemeName
highlight default link asemeName_918 asemeName
highlight default link asemeName_933 asemeName
highlight default link asemeName_935 asemeName
highlight default link asemeName_941 asemeName
highlight default link asemeName_96 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_11 asemeNumber
highlight default link asemeNumber_110 asemeNumber
highlight default link asemeNumber_117 asemeNumber
highlight default link asemeNumber_218 asemeNumber
highlight default link asemeNumber_222 asemeNumber
highlight default link asemeNumber_246 asemeNumber
highlight default link asemeNumber_30 asemeNumber
highlight default link asemeNumber_334 asemeNumber
highlight default link asemeNumber_336 asemeNumber
highlight default link asemeNumber_351 asemeNumber
highlight default link asemeNumber_362 asemeNumber
highlight default link asemeNumber_381 asemeNumber
highlight default link asemeNumber_385 asemeNumber
highlight default link asemeNumber_400 asemeNumber
highlight default link asemeNumber_419 asemeNumber
highlight default link asemeNumber_421 asemeNumber
highlight default link asemeNumber_437 asemeNumber
highlight default link asemeNumber_455 asemeNumber
highlight default link asemeNumber_459 asemeNumber
highlight default link asemeNumber_46 asemeNumber
highlight default link asemeNumber_559 asemeNumber
highlight default link asemeNumber_612 asemeNumber
highlight default link asemeNumber_614 asemeNumber
highlight default link asemeNumber_629 asemeNumber
highlight default link asemeNumber_632 asemeNumber
highlight default link asemeNumber_635 asemeNumber
highlight default link asemeNumber_644 asemeNumber
highlight default link asemeNumber_68 asemeNumber
highlight default link asemeNumber_688 asemeNumber
highlight default link asemeNumber_691 asemeNumber
highlight default link asemeNumber_694 asemeNumber
highlight default link asemeNumber_703 asemeNumber
highlight default link asemeNumber_769 asemeNumber
highlight default link asemeNumber_777 asemeNumber
highlight default link asemeNumber_782 asemeNumber
highlight default link asemeNumber_786 asemeNumber
highlight default link asemeNumber_80 asemeNumber
highlight default link asemeNumber_800 asemeNumber
highlight default link asemeNumber_818 asemeNumber
highlight default link asemeNumber_839 asemeNumber
highlight default link asemeNumber_900 asemeNumber
highlight default link asemeNumber_924 asemeNumber
highlight default link asemeNumber_928 asemeNumber
highlight default link asemeNumber_949 asemeNumber
highlight default link asemeNumber_955 asemeNumber
highlight default link asemeNumber_961 asemeNumber
highlight default link asemeNumber_967 asemeNumber
highlight default link asemeNumber_978 asemeNumber
highlight default link asemeNumber_990 asemeNumber
highlight default link asemeOperator_135 asemeOperator
highlight default link asemeOperator_26 asemeOperator
highlight default link asemeOperator_261 asemeOperator
highlight default link asemeOperator_263 asemeOperator
highlight default link asemeOperator_280 asemeOperator
highlight default link asemeOperator_337 asemeOperator
highlight default link asemeOperator_339 asemeOperator
highlight default link asemeOperator_371 asemeOperator
highlight default link asemeOperator_376 asemeOperator
highlight default link asemeOperator_386 asemeOperator
highlight default link asemeOperator_415 asemeOperator
highlight default link asemeOperator_422 asemeOperator
highlight default link asemeOperator_452 asemeOperator
highlight default link asemeOperator_457 asemeOperator
highlight default link asemeOperator_462 asemeOperator
highlight default link asemeOperator_464 asemeOperator
highlight default link asemeOperator_467 asemeOperator
highlight default link asemeOperator_492 asemeOperator
highlight default link asemeOperator_502 asemeOperator
highlight default link asemeOperator_528 asemeOperator
highlight default link asemeOperator_574 asemeOperator
highlight default link asemeOperator_576 asemeOperator
highlight default link asemeOperator_593 asemeOperator
highlight default link asemeOperator_61 asemeOperator
highlight default link asemeOperator_615 asemeOperator
highlight default link asemeOperator_617 asemeOperator
highlight default link asemeOperator_63 asemeOperator
highlight default link asemeOperator_70 asemeOperator
highlight default link asemeOperator_722 asemeOperator
highlight default link asemeOperator_737 asemeOperator
highlight default link asemeOperator_739 asemeOperator
highlight default link asemeOperator_742 asemeOperator
highlight default link asemeOperator_784 asemeOperator
highlight default link asemeOperator_815 asemeOperator
highlight default link asemeOperator_82 asemeOperator
highlight default link asemeOperator_854 asemeOperator
highlight default link asemeOperator_856 asemeOperator
highlight default link asemeOperator_873 asemeOperator
highlight default link asemeOperator_915 asemeOperator
highlight default link asemeOperator_917 asemeOperator
highlight default link asemeOperator_932 asemeOperator
highlight default link asemeOperator_951 asemeOperator
highlight default link asemeOperator_957 asemeOperator
highlight default link asemeOperator_963 asemeOperator
highlight default link asemeOperator_969 asemeOperator
highlight default link asemeOperator_980 asemeOperator
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
highlight default link asemePunctuation_296 asemePunctuation
highlight default link asemePunctuation_310 asemePunctuation
highlight default link asemePunctuation_322 asemePunctuation
highlight default link asemePunctuation_326 asemePunctuation
highlight default link asemePunctuation_329 asemePunctuation
highlight default link asemePunctuation_33 asemePunctuation
highlight default link asemePunctuation_331 asemePunctuation
highlight default link asemePunctuation_338 asemePunctuation
highlight default link asemePunctuation_341 asemePunctuation
highlight default link asemePunctuation_35 asemePunctuation
highlight default link asemePunctuation_368 asemePunctuation
highlight default link asemePunctuation_373 asemePunctuation
highlight default link asemePunctuation_389 asemePunctuation
highlight default link asemePunctuation_416 asemePunctuation
highlight default link asemePunctuation_417 asemePunctuation
highlight default link asemePunctuation_423 asemePunctuation
highlight default link asemePunctuation_426 asemePunctuation
highlight default link asemePunctuation_453 asemePunctuation
highlight default link asemePunctuation_454 asemePunctuation
highlight default link asemePunctuation_461 asemePunctuation
highlight default link asemePunctuation_472 asemePunctuation
highlight default link asemePunctuation_484 asemePunctuation
highlight default link asemePunctuation_505 asemePunctuation
highlight default link asemePunctuation_509 asemePunctuation
highlight default link asemePunctuation_512 asemePunctuation
highlight default link asemePunctuation_515 asemePunctuation
highlight default link asemePunctuation_520 asemePunctuation
highlight default link asemePunctuation_531 asemePunctuation
highlight default link asemePunctuation_545 asemePunctuation
highlight default link asemePunctuation_548 asemePunctuation
highlight default link asemePunctuation_575 asemePunctuation
highlight default link asemePunctuation_579 asemePunctuation
highlight default link asemePunctuation_587 asemePunctuation
highlight default link asemePunctuation_600 asemePunctuation
highlight default link asemePunctuation_604 asemePunctuation
highlight default link asemePunctuation_607 asemePunctuation
highlight default link asemePunctuation_609 asemePunctuation
highlight default link asemePunctuation_616 asemePunctuation
highlight default link asemePunctuation_619 asemePunctuation
highlight default link asemePunctuation_62 asemePunctuation
highlight default link asemePunctuation_656 asemePunctuation
highlight default link asemePunctuation_660 asemePunctuation
highlight default link asemePunctuation_664 asemePunctuation
highlight default link asemePunctuation_674 asemePunctuation
highlight default link asemePunctuation_676 asemePunctuation
highlight default link asemePunctuation_678 asemePunctuation
highlight default link asemePunctuation_719 asemePunctuation
highlight default link asemePunctuation_72 asemePunctuation
highlight default link asemePunctuation_725 asemePunctuation
highlight default link asemePunctuation_731 asemePunctuation
highlight default link asemePunctuation_74 asemePunctuation
highlight default link asemePunctuation_747 asemePunctuation
highlight default link asemePunctuation_781 asemePunctuation
highlight default link asemePunctuation_789 asemePunctuation
highlight default link asemePunctuation_816 asemePunctuation
highlight default link asemePunctuation_817 asemePunctuation
highlight default link asemePunctuation_825 asemePunctuation
highlight default link asemePunctuation_828 asemePunctuation
highlight default link asemePunctuation_84 asemePunctuation
highlight default link asemePunctuation_855 asemePunctuation
highlight default link asemePunctuation_859 asemePunctuation
highlight default link asemePunctuation_867 asemePunctuation
highlight default link asemePunctuation_882 asemePunctuation
highlight default link asemePunctuation_889 asemePunctuation
highlight default link asemePunctuation_916 asemePunctuation
highlight default link asemePunctuation_922 asemePunctuation
highlight default link asemePunctuation_926 asemePunctuation
highlight default link asemePunctuation_930 asemePunctuation
highlight default link asemePunctuation_936 asemePunctuation
highlight default link asemePunctuation_939 asemePunctuation
highlight default link asemePunctuation_942 asemePunctuation
highlight default link asemePunctuation_952 asemePunctuation
highlight default link asemePunctuation_953 asemePunctuation
highlight default link asemePunctuation_958 asemePunctuation
highlight default link asemePunctuation_959 asemePunctuation
highlight default link asemePunctuation_964 asemePunctuation
highlight default link asemePunctuation_965 asemePunctuation
highlight default link asemePunctuation_970 asemePunctuation
highlight default link asemePunctuation_971 asemePunctuation
highlight default link asemePunctuation_981 asemePunctuation
highlight default link asemePunctuation_982 asemePunctuation
highlight default link asemePunctuation_993 asemePunctuation
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
highlight default link asemeReference_289 asemeReference
highlight default link asemeReference_293 asemeReference
highlight default link asemeReference_294 asemeReference
highlight default link asemeReference_298 asemeReference
highlight default link asemeReference_299 asemeReference
highlight default link asemeReference_301 asemeReference
highlight default link asemeReference_302 asemeReference
highlight default link asemeReference_306 asemeReference
highlight default link asemeReference_308 asemeReference
highlight default link asemeReference_31 asemeReference
highlight default link asemeReference_312 asemeReference
highlight default link asemeReference_313 asemeReference
highlight default link asemeReference_315 asemeReference
highlight default link asemeReference_316 asemeReference
highlight default link asemeReference_32 asemeReference
highlight default link asemeReference_335 asemeReference
highlight default link asemeReference_36 asemeReference
highlight default link asemeReference_370 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_390 asemeReference
highlight default link asemeReference_392 asemeReference
highlight default link asemeReference_396 asemeReference
highlight default link asemeReference_414 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_420 asemeReference
highlight default link asemeReference_427 asemeReference
highlight default link asemeReference_429 asemeReference
highlight default link asemeReference_433 asemeReference
highlight default link asemeReference_451 asemeReference
highlight default link asemeReference_482 asemeReference
highlight default link asemeReference_486 asemeReference
highlight default link asemeReference_487 asemeReference
highlight default link asemeReference_490 asemeReference
highlight default link asemeReference_494 asemeReference
highlight default link asemeReference_498 asemeReference
highlight default link asemeReference_501 asemeReference
highlight default link asemeReference_504 asemeReference
highlight default link asemeReference_507 asemeReference
highlight default link asemeReference_511 asemeReference
highlight default link asemeReference_514 asemeReference
highlight default link asemeReference_517 asemeReference
highlight default link asemeReference_519 asemeReference
highlight default link asemeReference_522 asemeReference
highlight default link asemeReference_526 asemeReference
highlight default link asemeReference_530 asemeReference
highlight default link asemeReference_549 asemeReference
highlight default link asemeReference_551 asemeReference
highlight default link asemeReference_555 asemeReference
highlight default link asemeReference_573 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_60 asemeReference
highlight default link asemeReference_613 asemeReference
highlight default link asemeReference_622 asemeReference
highlight default link asemeReference_626 asemeReference
highlight default link asemeReference_641 asemeReference
highlight default link asemeReference_647 asemeReference
highlight default link asemeReference_650 asemeReference
highlight default link asemeReference_668 asemeReference
highlight default link asemeReference_671 asemeReference
highlight default link asemeReference_672 asemeReference
highlight default link asemeReference_673 asemeReference
highlight default link asemeReference_681 asemeReference
highlight default link asemeReference_685 asemeReference
highlight default link asemeReference_700 asemeReference
highlight default link asemeReference_706 asemeReference
highlight default link asemeReference_709 asemeReference
highlight default link asemeReference_713 asemeReference
highlight default link asemeReference_716 asemeReference
highlight default link asemeReference_717 asemeReference
highlight default link asemeReference_718 asemeReference
highlight default link asemeReference_757 asemeReference
highlight default link asemeReference_790 asemeReference
highlight default link asemeReference_792 asemeReference
highlight default link asemeReference_796 asemeReference
highlight default link asemeReference_814 asemeReference
highlight default link asemeReference_829 asemeReference
highlight default link asemeReference_831 asemeReference
highlight default link asemeReference_835 asemeReference
highlight default link asemeReference_853 asemeReference
highlight default link asemeReference_890 asemeReference
highlight default link asemeReference_892 asemeReference
highlight default link asemeReference_896 asemeReference
highlight default link asemeReference_914 asemeReference
highlight default link asemeReference_938 asemeReference
highlight default link asemeReference_950 asemeReference
highlight default link asemeReference_956 asemeReference
highlight default link asemeReference_962 asemeReference
highlight default link asemeReference_968 asemeReference
highlight default link asemeReference_979 asemeReference
highlight default link asemeReference_991 asemeReference
highlight default link asemeReference_992 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_133 asemeText
highlight default link asemeText_172 asemeText
highlight default link asemeText_210 asemeText
highlight default link asemeText_226 asemeText
highlight default link asemeText_245 asemeText
highlight default link asemeText_28 asemeText
highlight default link asemeText_29 asemeText
highlight default link asemeText_332 asemeText
highlight default link asemeText_346 asemeText
highlight default link asemeText_399 asemeText
highlight default link asemeText_418 asemeText
highlight default link asemeText_436 asemeText
highlight default link asemeText_45 asemeText
highlight default link asemeText_533 asemeText
highlight default link asemeText_534 asemeText
highlight default link asemeText_537 asemeText
highlight default link asemeText_558 asemeText
highlight default link asemeText_610 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_721 asemeText
highlight default link asemeText_728 asemeText
highlight default link asemeText_762 asemeText
highlight default link asemeText_766 asemeText
highlight default link asemeText_772 asemeText
highlight default link asemeText_774 asemeText
highlight default link asemeText_799 asemeText
highlight default link asemeText_838 asemeText
highlight default link asemeText_899 asemeText
highlight default link asemeText_948 asemeText
highlight default link asemeText_954 asemeText
highlight default link asemeText_960 asemeText
highlight default link asemeText_966 asemeText
highlight default link asemeText_972 asemeText
highlight default link asemeText_974 asemeText
highlight default link asemeText_977 asemeText
highlight default link asemeText_983 asemeText
highlight default link asemeText_985 asemeText
highlight default link asemeText_988 asemeText
highlight default link asemeText_989 asemeText
highlight default link asemeTruth_12 asemeTruth
highlight default link asemeTruth_247 asemeTruth
highlight default link asemeTruth_401 asemeTruth
highlight default link asemeTruth_438 asemeTruth
highlight default link asemeTruth_47 asemeTruth
highlight default link asemeTruth_560 asemeTruth
highlight default link asemeTruth_801 asemeTruth
highlight default link asemeTruth_840 asemeTruth
highlight default link asemeTruth_901 asemeTruth
highlight default link asemeType_139 asemeType
highlight default link asemeType_147 asemeType
highlight default link asemeType_154 asemeType
highlight default link asemeType_231 asemeType
highlight default link asemeType_265 asemeType
highlight default link asemeType_271 asemeType
highlight default link asemeType_273 asemeType
highlight default link asemeType_325 asemeType
highlight default link asemeType_544 asemeType
highlight default link asemeType_578 asemeType
highlight default link asemeType_584 asemeType
highlight default link asemeType_586 asemeType
highlight default link asemeType_603 asemeType
highlight default link asemeType_655 asemeType
highlight default link asemeType_663 asemeType
highlight default link asemeType_824 asemeType
highlight default link asemeType_858 asemeType
highlight default link asemeType_864 asemeType
highlight default link asemeType_866 asemeType
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
