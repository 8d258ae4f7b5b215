" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1010 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1009 /\v\w+/
syntax match asemeNumber_1008 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1007 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1006 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1011 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1006,asemeText_1007,asemeNumber_1008,asemeReference_1009,asemeReference_1010,asemePunctuation_1011,asemeComment
syntax match asemeReference_34 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_33 /\v\w+/ contained
syntax match asemeNumber_32 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_31 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_30 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_35 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_70,asemeDeclaration_82,asemeDeclaration_108,asemeDeclaration_135,asemeDeclaration_165,asemeDeclaration_188,asemeDeclaration_220,asemeDeclaration_486,asemeDeclaration_764,asemeDeclaration_767,asemeDeclaration_902,asemeDeclaration_964,asemeDeclaration_993,asemeDeclaration_1004,asemeText_1006,asemeText_1007,asemeNumber_1008,asemeReference_1009,asemeReference_1010,asemePunctuation_1011,asemeComment
syntax match asemeDeclaration_1004 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1003,asemeComment_1005 skipwhite skipempty
syntax region asemeComment_1005 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1003,asemeComment_1005 skipwhite skipempty
syntax match asemeComment_1005 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1003,asemeComment_1005 skipwhite skipempty
syntax match asemeText_1003 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1002 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1000,asemeText_1001
syntax match asemeText_1001 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1002 skipwhite skipempty
syntax region asemeComment_1002 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1002 skipwhite skipempty
syntax match asemeComment_1002 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1002 skipwhite skipempty
syntax region asemePunctuation_1000 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_983,asemeText_995,asemeNumber_996,asemeReference_997,asemeOperator_998,asemePunctuation_999,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_999 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_998 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_997 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_996 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_995 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_993 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_992,asemeComment_994 skipwhite skipempty
syntax region asemeComment_994 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_992,asemeComment_994 skipwhite skipempty
syntax match asemeComment_994 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_992,asemeComment_994 skipwhite skipempty
syntax match asemeText_992 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_991 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_989,asemeText_990
syntax match asemeText_990 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_991 skipwhite skipempty
syntax region asemeComment_991 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_991 skipwhite skipempty
syntax match asemeComment_991 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_991 skipwhite skipempty
syntax region asemePunctuation_989 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_983,asemeText_984,asemeNumber_985,asemeReference_986,asemeOperator_987,asemePunctuation_988,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_988 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_987 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_986 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_985 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_984 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_983 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_977,asemeText_978,asemeNumber_979,asemeReference_980,asemeOperator_981,asemePunctuation_982,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_982 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_981 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_980 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_979 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_978 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_977 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_971,asemeText_972,asemeNumber_973,asemeReference_974,asemeOperator_975,asemePunctuation_976,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_976 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_975 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_974 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_973 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_972 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_971 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_966,asemeNumber_967,asemeReference_968,asemeOperator_969,asemePunctuation_970,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_970 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_969 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_968 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_967 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_966 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_964 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_963,asemeComment_965 skipwhite skipempty
syntax region asemeComment_965 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_963,asemeComment_965 skipwhite skipempty
syntax match asemeComment_965 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_963,asemeComment_965 skipwhite skipempty
syntax match asemeBlock_963 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_962 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_960,asemeBlock_961
syntax match asemeBlock_961 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_962 skipwhite skipempty
syntax region asemeComment_962 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_962 skipwhite skipempty
syntax match asemeComment_962 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_962 skipwhite skipempty
syntax region asemePunctuation_960 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_959,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_959 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_941 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_938,asemePunctuation_948,asemePunctuation_954,asemePunctuation_957
syntax match asemePunctuation_957 /\v\:/ contained nextgroup=asemeReference_956,asemeComment_958 skipwhite skipempty
syntax region asemeComment_958 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_956,asemeComment_958 skipwhite skipempty
syntax match asemeComment_958 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_956,asemeComment_958 skipwhite skipempty
syntax match asemeReference_956 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_941 skipwhite skipempty
syntax match asemePunctuation_954 /\v\,/ contained nextgroup=asemeName_951,asemeName_953,asemeComment_955 skipwhite skipempty
syntax region asemeComment_955 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_951,asemeName_953,asemeComment_955 skipwhite skipempty
syntax match asemeComment_955 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_951,asemeName_953,asemeComment_955 skipwhite skipempty
syntax match asemeName_953 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_941 skipwhite skipempty
syntax match asemeName_951 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_950,asemeComment_952 skipwhite skipempty
syntax region asemeComment_952 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_950,asemeComment_952 skipwhite skipempty
syntax match asemeComment_952 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_950,asemeComment_952 skipwhite skipempty
syntax match asemeOperator_950 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemePunctuation_948 /\v\[/ contained nextgroup=asemeNumber_946,asemeComment_949 skipwhite skipempty
syntax region asemeComment_949 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_946,asemeComment_949 skipwhite skipempty
syntax match asemeComment_949 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_946,asemeComment_949 skipwhite skipempty
syntax match asemeNumber_946 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_944,asemeComment_947 skipwhite skipempty
syntax region asemeComment_947 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_944,asemeComment_947 skipwhite skipempty
syntax match asemeComment_947 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_944,asemeComment_947 skipwhite skipempty
syntax match asemePunctuation_944 /\v\.\./ contained nextgroup=asemeNumber_942,asemeComment_945 skipwhite skipempty
syntax region asemeComment_945 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_942,asemeComment_945 skipwhite skipempty
syntax match asemeComment_945 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_942,asemeComment_945 skipwhite skipempty
syntax match asemeNumber_942 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_940,asemeComment_943 skipwhite skipempty
syntax region asemeComment_943 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_940,asemeComment_943 skipwhite skipempty
syntax match asemeComment_943 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_940,asemeComment_943 skipwhite skipempty
syntax match asemePunctuation_940 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_941 skipwhite skipempty
syntax region asemeComment_941 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_941 skipwhite skipempty
syntax match asemeComment_941 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_941 skipwhite skipempty
syntax match asemeClause_938 /\vwith%(<|>)/ contained nextgroup=asemeName_936,asemeComment_939 skipwhite skipempty
syntax region asemeComment_939 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_936,asemeComment_939 skipwhite skipempty
syntax match asemeComment_939 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_936,asemeComment_939 skipwhite skipempty
syntax match asemeName_936 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_935,asemeComment_937 skipwhite skipempty
syntax region asemeComment_937 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_935,asemeComment_937 skipwhite skipempty
syntax match asemeComment_937 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_935,asemeComment_937 skipwhite skipempty
syntax match asemeOperator_935 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeDeclaration_902 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_901,asemeComment_903 skipwhite skipempty
syntax region asemeComment_903 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_901,asemeComment_903 skipwhite skipempty
syntax match asemeComment_903 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_901,asemeComment_903 skipwhite skipempty
syntax match asemeBlock_901 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_900 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_898,asemeBlock_899
syntax match asemeBlock_899 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_900 skipwhite skipempty
syntax region asemeComment_900 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_900 skipwhite skipempty
syntax match asemeComment_900 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_900 skipwhite skipempty
syntax region asemePunctuation_898 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_791,asemeNumber_798,asemeDeclaration_834,asemeDeclaration_887,asemeDeclaration_892,asemeDeclaration_894,asemeDeclaration_896,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_896 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_897 skipwhite skipempty
syntax region asemeComment_897 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_897 skipwhite skipempty
syntax match asemeComment_897 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_897 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_737
syntax match asemeDeclaration_894 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_895 skipwhite skipempty
syntax region asemeComment_895 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_895 skipwhite skipempty
syntax match asemeComment_895 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_895 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_690
syntax match asemeDeclaration_892 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_890,asemeComment_893 skipwhite skipempty
syntax region asemeComment_893 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_890,asemeComment_893 skipwhite skipempty
syntax match asemeComment_893 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_890,asemeComment_893 skipwhite skipempty
syntax match asemeName_890 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_889,asemeComment_891 skipwhite skipempty
syntax region asemeComment_891 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_889,asemeComment_891 skipwhite skipempty
syntax match asemeComment_891 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_889,asemeComment_891 skipwhite skipempty
syntax match asemeOperator_889 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_887 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_885,asemeComment_888 skipwhite skipempty
syntax region asemeComment_888 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_885,asemeComment_888 skipwhite skipempty
syntax match asemeComment_888 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_885,asemeComment_888 skipwhite skipempty
syntax match asemeName_885 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_883,asemeComment_886 skipwhite skipempty
syntax region asemeComment_886 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_883,asemeComment_886 skipwhite skipempty
syntax match asemeComment_886 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_883,asemeComment_886 skipwhite skipempty
syntax match asemePunctuation_883 /\v\:/ contained nextgroup=asemeBuiltIn_881,asemeType_882,asemeComment_884 skipwhite skipempty
syntax region asemeComment_884 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_881,asemeType_882,asemeComment_884 skipwhite skipempty
syntax match asemeComment_884 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_881,asemeType_882,asemeComment_884 skipwhite skipempty
syntax match asemeType_882 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeBuiltIn_881 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_839,asemeOperator_872,asemeName_877,asemeBuiltIn_879,asemeType_880
syntax match asemeType_880 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeBuiltIn_879 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeName_877 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_875,asemeComment_878 skipwhite skipempty
syntax region asemeComment_878 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_875,asemeComment_878 skipwhite skipempty
syntax match asemeComment_878 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_875,asemeComment_878 skipwhite skipempty
syntax match asemePunctuation_875 /\v\:/ contained nextgroup=asemeBuiltIn_873,asemeType_874,asemeComment_876 skipwhite skipempty
syntax region asemeComment_876 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_873,asemeType_874,asemeComment_876 skipwhite skipempty
syntax match asemeComment_876 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_873,asemeType_874,asemeComment_876 skipwhite skipempty
syntax match asemeType_874 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeBuiltIn_873 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeOperator_872 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemePunctuation_839 /\v\:/ contained nextgroup=asemeBuiltIn_836,asemeType_838,asemeComment_840 skipwhite skipempty
syntax region asemeComment_840 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_836,asemeType_838,asemeComment_840 skipwhite skipempty
syntax match asemeComment_840 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_836,asemeType_838,asemeComment_840 skipwhite skipempty
syntax match asemeType_838 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeBuiltIn_836 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_837 skipwhite skipempty
syntax match asemeDeclaration_834 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_832,asemeComment_835 skipwhite skipempty
syntax region asemeComment_835 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_832,asemeComment_835 skipwhite skipempty
syntax match asemeComment_835 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_832,asemeComment_835 skipwhite skipempty
syntax match asemeNumber_832 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_831,asemeComment_833 skipwhite skipempty
syntax region asemeComment_833 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_831,asemeComment_833 skipwhite skipempty
syntax match asemeComment_833 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_831,asemeComment_833 skipwhite skipempty
syntax match asemePunctuation_831 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeNumber_798 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_796,asemeComment_799 skipwhite skipempty
syntax region asemeComment_799 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_796,asemeComment_799 skipwhite skipempty
syntax match asemeComment_799 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_796,asemeComment_799 skipwhite skipempty
syntax match asemeOperator_796 /\v\-\>/ contained nextgroup=asemeNumber_794,asemeComment_797 skipwhite skipempty
syntax region asemeComment_797 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_794,asemeComment_797 skipwhite skipempty
syntax match asemeComment_797 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_794,asemeComment_797 skipwhite skipempty
syntax match asemeNumber_794 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_793,asemeComment_795 skipwhite skipempty
syntax region asemeComment_795 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_793,asemeComment_795 skipwhite skipempty
syntax match asemeComment_795 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_793,asemeComment_795 skipwhite skipempty
syntax match asemePunctuation_793 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeDeclaration_791 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_789,asemeComment_792 skipwhite skipempty
syntax region asemeComment_792 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_789,asemeComment_792 skipwhite skipempty
syntax match asemeComment_792 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_789,asemeComment_792 skipwhite skipempty
syntax match asemeNumber_789 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_787,asemeComment_790 skipwhite skipempty
syntax region asemeComment_790 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_787,asemeComment_790 skipwhite skipempty
syntax match asemeComment_790 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_787,asemeComment_790 skipwhite skipempty
syntax match asemeChoice_787 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_785,asemeText_786,@asemeChartNodeInBodyOfStatechart,asemeComment_788 skipwhite skipempty
syntax region asemeComment_788 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_785,asemeText_786,@asemeChartNodeInBodyOfStatechart,asemeComment_788 skipwhite skipempty
syntax match asemeComment_788 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_785,asemeText_786,@asemeChartNodeInBodyOfStatechart,asemeComment_788 skipwhite skipempty
syntax match asemeText_786 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeName_785 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_771,asemeChoice_775,asemeNumber_781,asemeName_783,asemeText_784
syntax match asemeText_784 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeName_783 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeNumber_781 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_779,asemeComment_782 skipwhite skipempty
syntax region asemeComment_782 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_779,asemeComment_782 skipwhite skipempty
syntax match asemeComment_782 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_779,asemeComment_782 skipwhite skipempty
syntax match asemeChoice_779 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_777,asemeText_778,@asemeChartNodeInBodyOfStatechart,asemeComment_780 skipwhite skipempty
syntax region asemeComment_780 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_777,asemeText_778,@asemeChartNodeInBodyOfStatechart,asemeComment_780 skipwhite skipempty
syntax match asemeComment_780 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_777,asemeText_778,@asemeChartNodeInBodyOfStatechart,asemeComment_780 skipwhite skipempty
syntax match asemeText_778 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeName_777 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeChoice_775 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_773,asemeText_774,@asemeChartNodeInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_773,asemeText_774,@asemeChartNodeInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_773,asemeText_774,@asemeChartNodeInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax match asemeText_774 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeName_773 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeClause_771 /\vactivity%(<|>)/ contained nextgroup=asemeReference_769,asemeComment_772 skipwhite skipempty
syntax region asemeComment_772 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_769,asemeComment_772 skipwhite skipempty
syntax match asemeComment_772 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_769,asemeComment_772 skipwhite skipempty
syntax match asemeReference_769 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax region asemeComment_770 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeComment_770 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_770 skipwhite skipempty
syntax match asemeDeclaration_767 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_766,asemeComment_768 skipwhite skipempty
syntax region asemeComment_768 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_766,asemeComment_768 skipwhite skipempty
syntax match asemeComment_768 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_766,asemeComment_768 skipwhite skipempty
syntax match asemeBlock_766 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_489 skipwhite skipempty
syntax match asemeDeclaration_764 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_762,asemeComment_765 skipwhite skipempty
syntax region asemeComment_765 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_762,asemeComment_765 skipwhite skipempty
syntax match asemeComment_765 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_762,asemeComment_765 skipwhite skipempty
syntax match asemeClause_762 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_761,asemeComment_763 skipwhite skipempty
syntax region asemeComment_763 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_761,asemeComment_763 skipwhite skipempty
syntax match asemeComment_763 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_761,asemeComment_763 skipwhite skipempty
syntax match asemeBlock_761 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_489 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_490,asemePunctuation_759,asemeBlock_760
syntax match asemeBlock_760 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_489 skipwhite skipempty
syntax region asemePunctuation_759 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_498,asemeDeclaration_534,asemeDeclaration_550,asemeDeclaration_603,asemeDeclaration_608,asemeDeclaration_632,asemeDeclaration_691,asemeDeclaration_738,asemeDeclaration_747,asemeDeclaration_757,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_757 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_755,asemeComment_758 skipwhite skipempty
syntax region asemeComment_758 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_755,asemeComment_758 skipwhite skipempty
syntax match asemeComment_758 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_755,asemeComment_758 skipwhite skipempty
syntax match asemeBlock_755 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_754,@asemeControlInBodyOfSrm,asemeComment_756 skipwhite skipempty
syntax region asemeComment_756 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_754,@asemeControlInBodyOfSrm,asemeComment_756 skipwhite skipempty
syntax match asemeComment_756 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_754,@asemeControlInBodyOfSrm,asemeComment_756 skipwhite skipempty
syntax match asemeOperator_754 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_471,asemeOperator_749,asemeBlock_752
syntax match asemeBlock_752 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_751,@asemeControlInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax region asemeComment_753 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_751,@asemeControlInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeComment_753 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_751,@asemeControlInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeOperator_751 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeOperator_749 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax region asemeComment_750 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeComment_750 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeDeclaration_747 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_746,asemeComment_748 skipwhite skipempty
syntax region asemeComment_748 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_746,asemeComment_748 skipwhite skipempty
syntax match asemeComment_748 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_746,asemeComment_748 skipwhite skipempty
syntax match asemeBlock_746 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_745 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_743,asemeBlock_744
syntax match asemeBlock_744 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_745 skipwhite skipempty
syntax region asemeComment_745 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_745 skipwhite skipempty
syntax match asemeComment_745 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_745 skipwhite skipempty
syntax region asemePunctuation_743 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_741,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_741 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_740,asemeComment_742 skipwhite skipempty
syntax region asemeComment_742 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_740,asemeComment_742 skipwhite skipempty
syntax match asemeComment_742 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_740,asemeComment_742 skipwhite skipempty
syntax match asemeText_740 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_738 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_739 skipwhite skipempty
syntax region asemeComment_739 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_739 skipwhite skipempty
syntax match asemeComment_739 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_739 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_737
syntax region asemePunctuation_737 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_736,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_736 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_698,asemeClause_701,asemeClause_704,asemeClause_707,asemeClause_710,asemeClause_713,asemeClause_716,asemeClause_719,asemeClause_722,asemeClause_724,asemePunctuation_731,asemeOperator_734
syntax match asemeOperator_734 /\v\=%(\=)@!/ contained nextgroup=asemeText_733,asemeComment_735 skipwhite skipempty
syntax region asemeComment_735 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_733,asemeComment_735 skipwhite skipempty
syntax match asemeComment_735 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_733,asemeComment_735 skipwhite skipempty
syntax match asemeText_733 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemePunctuation_731 /\v\,/ contained nextgroup=asemeChoice_726,asemeReference_728,asemeReference_729,asemeReference_730,asemeComment_732 skipwhite skipempty
syntax region asemeComment_732 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_726,asemeReference_728,asemeReference_729,asemeReference_730,asemeComment_732 skipwhite skipempty
syntax match asemeComment_732 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_726,asemeReference_728,asemeReference_729,asemeReference_730,asemeComment_732 skipwhite skipempty
syntax match asemeReference_730 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeReference_729 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeReference_728 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeChoice_726 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_725,asemeComment_727 skipwhite skipempty
syntax region asemeComment_727 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_725,asemeComment_727 skipwhite skipempty
syntax match asemeComment_727 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_725,asemeComment_727 skipwhite skipempty
syntax match asemeReference_725 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_724 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_722 /\vends%(<|>)/ contained nextgroup=asemeReference_721,asemeComment_723 skipwhite skipempty
syntax region asemeComment_723 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_721,asemeComment_723 skipwhite skipempty
syntax match asemeComment_723 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_721,asemeComment_723 skipwhite skipempty
syntax match asemeReference_721 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_719 /\vwrites%(<|>)/ contained nextgroup=asemeReference_718,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_718,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_718,asemeComment_720 skipwhite skipempty
syntax match asemeReference_718 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_716 /\vfor%(<|>)/ contained nextgroup=asemeNumber_715,asemeComment_717 skipwhite skipempty
syntax region asemeComment_717 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_715,asemeComment_717 skipwhite skipempty
syntax match asemeComment_717 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_715,asemeComment_717 skipwhite skipempty
syntax match asemeNumber_715 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_713 /\vuses%(<|>)/ contained nextgroup=asemeReference_712,asemeComment_714 skipwhite skipempty
syntax region asemeComment_714 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_712,asemeComment_714 skipwhite skipempty
syntax match asemeComment_714 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_712,asemeComment_714 skipwhite skipempty
syntax match asemeReference_712 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_710 /\vas%(<|>)/ contained nextgroup=asemeChoice_709,asemeComment_711 skipwhite skipempty
syntax region asemeComment_711 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_709,asemeComment_711 skipwhite skipempty
syntax match asemeComment_711 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_709,asemeComment_711 skipwhite skipempty
syntax match asemeChoice_709 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_707 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_706,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_706,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_706,asemeComment_708 skipwhite skipempty
syntax match asemeNumber_706 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_704 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_703,asemeComment_705 skipwhite skipempty
syntax region asemeComment_705 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_703,asemeComment_705 skipwhite skipempty
syntax match asemeComment_705 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_703,asemeComment_705 skipwhite skipempty
syntax match asemeNumber_703 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_701 /\vevery%(<|>)/ contained nextgroup=asemeNumber_700,asemeComment_702 skipwhite skipempty
syntax region asemeComment_702 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_700,asemeComment_702 skipwhite skipempty
syntax match asemeComment_702 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_700,asemeComment_702 skipwhite skipempty
syntax match asemeNumber_700 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeClause_698 /\vreads%(<|>)/ contained nextgroup=asemeChoice_695,asemeReference_697,asemeComment_699 skipwhite skipempty
syntax region asemeComment_699 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_695,asemeReference_697,asemeComment_699 skipwhite skipempty
syntax match asemeComment_699 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_695,asemeReference_697,asemeComment_699 skipwhite skipempty
syntax match asemeReference_697 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeChoice_695 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_693,asemeComment_696 skipwhite skipempty
syntax region asemeComment_696 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_693,asemeComment_696 skipwhite skipempty
syntax match asemeComment_696 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_693,asemeComment_696 skipwhite skipempty
syntax match asemeReference_693 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_694 skipwhite skipempty
syntax match asemeDeclaration_691 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_692 skipwhite skipempty
syntax region asemeComment_692 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_692 skipwhite skipempty
syntax match asemeComment_692 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_692 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_690
syntax region asemePunctuation_690 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_689,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_689 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_639,asemeClause_642,asemeClause_645,asemeClause_648,asemeClause_651,asemeClause_654,asemeClause_657,asemeClause_660,asemeClause_663,asemeClause_665,asemePunctuation_672,asemePunctuation_686,asemePunctuation_688
syntax match asemePunctuation_688 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemePunctuation_686 /\v\,/ contained nextgroup=asemeName_678,asemeChoice_681,asemeReference_683,asemeReference_684,asemeReference_685,asemeComment_687 skipwhite skipempty
syntax region asemeComment_687 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_678,asemeChoice_681,asemeReference_683,asemeReference_684,asemeReference_685,asemeComment_687 skipwhite skipempty
syntax match asemeComment_687 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_678,asemeChoice_681,asemeReference_683,asemeReference_684,asemeReference_685,asemeComment_687 skipwhite skipempty
syntax match asemeReference_685 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeReference_684 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeReference_683 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeChoice_681 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_680,asemeComment_682 skipwhite skipempty
syntax region asemeComment_682 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_680,asemeComment_682 skipwhite skipempty
syntax match asemeComment_682 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_680,asemeComment_682 skipwhite skipempty
syntax match asemeReference_680 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeName_678 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_676,asemeComment_679 skipwhite skipempty
syntax region asemeComment_679 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_676,asemeComment_679 skipwhite skipempty
syntax match asemeComment_679 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_676,asemeComment_679 skipwhite skipempty
syntax match asemePunctuation_676 /\v\:/ contained nextgroup=asemeBuiltIn_674,asemeType_675,asemeComment_677 skipwhite skipempty
syntax region asemeComment_677 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_674,asemeType_675,asemeComment_677 skipwhite skipempty
syntax match asemeComment_677 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_674,asemeType_675,asemeComment_677 skipwhite skipempty
syntax match asemeType_675 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeBuiltIn_674 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemePunctuation_672 /\v\(/ contained nextgroup=asemeName_670,asemeComment_673 skipwhite skipempty
syntax region asemeComment_673 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_670,asemeComment_673 skipwhite skipempty
syntax match asemeComment_673 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_670,asemeComment_673 skipwhite skipempty
syntax match asemeName_670 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_668,asemeComment_671 skipwhite skipempty
syntax region asemeComment_671 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_668,asemeComment_671 skipwhite skipempty
syntax match asemeComment_671 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_668,asemeComment_671 skipwhite skipempty
syntax match asemePunctuation_668 /\v\:/ contained nextgroup=asemeBuiltIn_666,asemeType_667,asemeComment_669 skipwhite skipempty
syntax region asemeComment_669 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_666,asemeType_667,asemeComment_669 skipwhite skipempty
syntax match asemeComment_669 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_666,asemeType_667,asemeComment_669 skipwhite skipempty
syntax match asemeType_667 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeBuiltIn_666 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_665 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_663 /\vends%(<|>)/ contained nextgroup=asemeReference_662,asemeComment_664 skipwhite skipempty
syntax region asemeComment_664 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_662,asemeComment_664 skipwhite skipempty
syntax match asemeComment_664 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_662,asemeComment_664 skipwhite skipempty
syntax match asemeReference_662 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_660 /\vwrites%(<|>)/ contained nextgroup=asemeReference_659,asemeComment_661 skipwhite skipempty
syntax region asemeComment_661 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_659,asemeComment_661 skipwhite skipempty
syntax match asemeComment_661 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_659,asemeComment_661 skipwhite skipempty
syntax match asemeReference_659 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_657 /\vfor%(<|>)/ contained nextgroup=asemeNumber_656,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_656,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_656,asemeComment_658 skipwhite skipempty
syntax match asemeNumber_656 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_654 /\vuses%(<|>)/ contained nextgroup=asemeReference_653,asemeComment_655 skipwhite skipempty
syntax region asemeComment_655 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_653,asemeComment_655 skipwhite skipempty
syntax match asemeComment_655 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_653,asemeComment_655 skipwhite skipempty
syntax match asemeReference_653 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_651 /\vas%(<|>)/ contained nextgroup=asemeChoice_650,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_650,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_650,asemeComment_652 skipwhite skipempty
syntax match asemeChoice_650 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_648 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_647,asemeComment_649 skipwhite skipempty
syntax region asemeComment_649 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_647,asemeComment_649 skipwhite skipempty
syntax match asemeComment_649 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_647,asemeComment_649 skipwhite skipempty
syntax match asemeNumber_647 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_645 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_644,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_644,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_644,asemeComment_646 skipwhite skipempty
syntax match asemeNumber_644 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_642 /\vevery%(<|>)/ contained nextgroup=asemeNumber_641,asemeComment_643 skipwhite skipempty
syntax region asemeComment_643 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_641,asemeComment_643 skipwhite skipempty
syntax match asemeComment_643 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_641,asemeComment_643 skipwhite skipempty
syntax match asemeNumber_641 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeClause_639 /\vreads%(<|>)/ contained nextgroup=asemeChoice_636,asemeReference_638,asemeComment_640 skipwhite skipempty
syntax region asemeComment_640 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_636,asemeReference_638,asemeComment_640 skipwhite skipempty
syntax match asemeComment_640 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_636,asemeReference_638,asemeComment_640 skipwhite skipempty
syntax match asemeReference_638 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeChoice_636 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_634,asemeComment_637 skipwhite skipempty
syntax region asemeComment_637 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_634,asemeComment_637 skipwhite skipempty
syntax match asemeComment_637 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_634,asemeComment_637 skipwhite skipempty
syntax match asemeReference_634 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax region asemeComment_635 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeComment_635 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_635 skipwhite skipempty
syntax match asemeDeclaration_632 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_633 skipwhite skipempty
syntax region asemeComment_633 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_633 skipwhite skipempty
syntax match asemeComment_633 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_633 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_631
syntax region asemePunctuation_631 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_630,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_630 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_612,asemePunctuation_616,asemePunctuation_619,asemePunctuation_621,asemeOperator_629
syntax match asemeOperator_629 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemePunctuation_621 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemePunctuation_619 /\v\,/ contained nextgroup=asemeName_618,asemeComment_620 skipwhite skipempty
syntax region asemeComment_620 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_618,asemeComment_620 skipwhite skipempty
syntax match asemeComment_620 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_618,asemeComment_620 skipwhite skipempty
syntax match asemeName_618 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemePunctuation_616 /\v\:/ contained nextgroup=asemeBuiltIn_614,asemeType_615,asemeComment_617 skipwhite skipempty
syntax region asemeComment_617 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_614,asemeType_615,asemeComment_617 skipwhite skipempty
syntax match asemeComment_617 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_614,asemeType_615,asemeComment_617 skipwhite skipempty
syntax match asemeType_615 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeBuiltIn_614 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemePunctuation_612 /\v\(/ contained nextgroup=asemeName_610,asemeComment_613 skipwhite skipempty
syntax region asemeComment_613 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_610,asemeComment_613 skipwhite skipempty
syntax match asemeComment_613 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_610,asemeComment_613 skipwhite skipempty
syntax match asemeName_610 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax region asemeComment_611 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeComment_611 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_611 skipwhite skipempty
syntax match asemeDeclaration_608 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_606,asemeComment_609 skipwhite skipempty
syntax region asemeComment_609 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_606,asemeComment_609 skipwhite skipempty
syntax match asemeComment_609 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_606,asemeComment_609 skipwhite skipempty
syntax match asemeName_606 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_605,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_605,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_605,asemeComment_607 skipwhite skipempty
syntax match asemeOperator_605 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_603 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_601,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_601,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_601,asemeComment_604 skipwhite skipempty
syntax match asemeName_601 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_599,asemeComment_602 skipwhite skipempty
syntax region asemeComment_602 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_599,asemeComment_602 skipwhite skipempty
syntax match asemeComment_602 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_599,asemeComment_602 skipwhite skipempty
syntax match asemePunctuation_599 /\v\:/ contained nextgroup=asemeBuiltIn_597,asemeType_598,asemeComment_600 skipwhite skipempty
syntax region asemeComment_600 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_597,asemeType_598,asemeComment_600 skipwhite skipempty
syntax match asemeComment_600 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_597,asemeType_598,asemeComment_600 skipwhite skipempty
syntax match asemeType_598 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeBuiltIn_597 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_555,asemeOperator_588,asemeName_593,asemeBuiltIn_595,asemeType_596
syntax match asemeType_596 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeBuiltIn_595 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeName_593 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_591,asemeComment_594 skipwhite skipempty
syntax region asemeComment_594 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_591,asemeComment_594 skipwhite skipempty
syntax match asemeComment_594 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_591,asemeComment_594 skipwhite skipempty
syntax match asemePunctuation_591 /\v\:/ contained nextgroup=asemeBuiltIn_589,asemeType_590,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_589,asemeType_590,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_589,asemeType_590,asemeComment_592 skipwhite skipempty
syntax match asemeType_590 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeBuiltIn_589 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeOperator_588 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemePunctuation_555 /\v\:/ contained nextgroup=asemeBuiltIn_552,asemeType_554,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_552,asemeType_554,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_552,asemeType_554,asemeComment_556 skipwhite skipempty
syntax match asemeType_554 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeBuiltIn_552 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax region asemeComment_553 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeComment_553 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_553 skipwhite skipempty
syntax match asemeDeclaration_550 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_548,asemeComment_551 skipwhite skipempty
syntax region asemeComment_551 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_548,asemeComment_551 skipwhite skipempty
syntax match asemeComment_551 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_548,asemeComment_551 skipwhite skipempty
syntax match asemeName_548 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_547,@asemeCapabilityInBodyOfSrm,asemeComment_549 skipwhite skipempty
syntax region asemeComment_549 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_547,@asemeCapabilityInBodyOfSrm,asemeComment_549 skipwhite skipempty
syntax match asemeComment_549 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_547,@asemeCapabilityInBodyOfSrm,asemeComment_549 skipwhite skipempty
syntax match asemeText_547 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_538,asemePunctuation_541,asemeText_543,asemeName_545
syntax match asemeName_545 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_544,@asemeCapabilityInBodyOfSrm,asemeComment_546 skipwhite skipempty
syntax region asemeComment_546 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_544,@asemeCapabilityInBodyOfSrm,asemeComment_546 skipwhite skipempty
syntax match asemeComment_546 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_544,@asemeCapabilityInBodyOfSrm,asemeComment_546 skipwhite skipempty
syntax match asemeText_544 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax match asemeText_543 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax match asemePunctuation_541 /\v\,/ contained nextgroup=asemeReference_540,asemeComment_542 skipwhite skipempty
syntax region asemeComment_542 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_540,asemeComment_542 skipwhite skipempty
syntax match asemeComment_542 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_540,asemeComment_542 skipwhite skipempty
syntax match asemeReference_540 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax match asemeOperator_538 /\v\=%(\=)@!/ contained nextgroup=asemeReference_536,asemeComment_539 skipwhite skipempty
syntax region asemeComment_539 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_536,asemeComment_539 skipwhite skipempty
syntax match asemeComment_539 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_536,asemeComment_539 skipwhite skipempty
syntax match asemeReference_536 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax region asemeComment_537 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax match asemeComment_537 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_537 skipwhite skipempty
syntax match asemeDeclaration_534 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax region asemeComment_535 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax match asemeComment_535 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax match asemeReference_532 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_530,asemeComment_533 skipwhite skipempty
syntax region asemeComment_533 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_530,asemeComment_533 skipwhite skipempty
syntax match asemeComment_533 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_530,asemeComment_533 skipwhite skipempty
syntax match asemePunctuation_530 /\v\./ contained nextgroup=asemeReference_529,asemeComment_531 skipwhite skipempty
syntax region asemeComment_531 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_529,asemeComment_531 skipwhite skipempty
syntax match asemeComment_531 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_529,asemeComment_531 skipwhite skipempty
syntax match asemeReference_529 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_506,asemeClause_509,asemePunctuation_519,asemePunctuation_522,asemeReference_527
syntax match asemeReference_527 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_525,@asemePlaysInBodyOfSrm,asemeComment_528 skipwhite skipempty
syntax region asemeComment_528 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_525,@asemePlaysInBodyOfSrm,asemeComment_528 skipwhite skipempty
syntax match asemeComment_528 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_525,@asemePlaysInBodyOfSrm,asemeComment_528 skipwhite skipempty
syntax match asemePunctuation_525 /\v\./ contained nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax region asemeComment_526 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeComment_526 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeReference_524 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemePunctuation_522 /\v\./ contained nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax region asemeComment_523 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax match asemeComment_523 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax match asemeReference_521 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemePunctuation_519 /\v\,/ contained nextgroup=asemeReference_517,asemeComment_520 skipwhite skipempty
syntax region asemeComment_520 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_517,asemeComment_520 skipwhite skipempty
syntax match asemeComment_520 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_517,asemeComment_520 skipwhite skipempty
syntax match asemeReference_517 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\=%(\=)@!|\.))@=/ contained nextgroup=asemeOperator_512,asemePunctuation_515,asemeComment_518 skipwhite skipempty
syntax region asemeComment_518 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_512,asemePunctuation_515,asemeComment_518 skipwhite skipempty
syntax match asemeComment_518 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_512,asemePunctuation_515,asemeComment_518 skipwhite skipempty
syntax match asemePunctuation_515 /\v\./ contained nextgroup=asemeReference_514,asemeComment_516 skipwhite skipempty
syntax region asemeComment_516 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_514,asemeComment_516 skipwhite skipempty
syntax match asemeComment_516 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_514,asemeComment_516 skipwhite skipempty
syntax match asemeReference_514 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemeOperator_512 /\v\=%(\=)@!/ contained nextgroup=asemeReference_511,asemeComment_513 skipwhite skipempty
syntax region asemeComment_513 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_511,asemeComment_513 skipwhite skipempty
syntax match asemeComment_513 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_511,asemeComment_513 skipwhite skipempty
syntax match asemeReference_511 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemeClause_509 /\vas%(<|>)/ contained nextgroup=asemeReference_508,asemeComment_510 skipwhite skipempty
syntax region asemeComment_510 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_508,asemeComment_510 skipwhite skipempty
syntax match asemeComment_510 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_508,asemeComment_510 skipwhite skipempty
syntax match asemeReference_508 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemeClause_506 /\vwith%(<|>)/ contained nextgroup=asemeReference_504,asemeComment_507 skipwhite skipempty
syntax region asemeComment_507 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_504,asemeComment_507 skipwhite skipempty
syntax match asemeComment_507 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_504,asemeComment_507 skipwhite skipempty
syntax match asemeReference_504 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_502,asemeComment_505 skipwhite skipempty
syntax region asemeComment_505 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_502,asemeComment_505 skipwhite skipempty
syntax match asemeComment_505 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_502,asemeComment_505 skipwhite skipempty
syntax match asemeOperator_502 /\v\=%(\=)@!/ contained nextgroup=asemeReference_500,asemeComment_503 skipwhite skipempty
syntax region asemeComment_503 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_500,asemeComment_503 skipwhite skipempty
syntax match asemeComment_503 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_500,asemeComment_503 skipwhite skipempty
syntax match asemeReference_500 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax region asemeComment_501 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemeComment_501 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_501 skipwhite skipempty
syntax match asemeDeclaration_498 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_497,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_497,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_497,asemeComment_499 skipwhite skipempty
syntax match asemeReference_497 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_493 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_494,asemeReference_496
syntax match asemeReference_496 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_493 skipwhite skipempty
syntax match asemePunctuation_494 /\v\,/ contained nextgroup=asemeReference_492,asemeComment_495 skipwhite skipempty
syntax region asemeComment_495 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_492,asemeComment_495 skipwhite skipempty
syntax match asemeComment_495 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_492,asemeComment_495 skipwhite skipempty
syntax match asemeReference_492 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_493 skipwhite skipempty
syntax match asemeClause_490 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_488,asemeComment_491 skipwhite skipempty
syntax region asemeComment_491 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_488,asemeComment_491 skipwhite skipempty
syntax match asemeComment_491 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_488,asemeComment_491 skipwhite skipempty
syntax match asemeBlock_488 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_489 skipwhite skipempty
syntax region asemeComment_489 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_489 skipwhite skipempty
syntax match asemeComment_489 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_489 skipwhite skipempty
syntax match asemeDeclaration_486 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_485,asemeComment_487 skipwhite skipempty
syntax region asemeComment_487 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_485,asemeComment_487 skipwhite skipempty
syntax match asemeComment_487 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_485,asemeComment_487 skipwhite skipempty
syntax match asemeBlock_485 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_484 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_482,asemeBlock_483
syntax match asemeBlock_483 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_484 skipwhite skipempty
syntax region asemeComment_484 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_484 skipwhite skipempty
syntax match asemeComment_484 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_484 skipwhite skipempty
syntax region asemePunctuation_482 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_350,asemeDeclaration_353,asemeDeclaration_381,asemeDeclaration_385,asemeDeclaration_480,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_480 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_478,asemeComment_481 skipwhite skipempty
syntax region asemeComment_481 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_478,asemeComment_481 skipwhite skipempty
syntax match asemeComment_481 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_478,asemeComment_481 skipwhite skipempty
syntax match asemeBlock_478 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_477,@asemeControlInBodyOfAip,asemeComment_479 skipwhite skipempty
syntax region asemeComment_479 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_477,@asemeControlInBodyOfAip,asemeComment_479 skipwhite skipempty
syntax match asemeComment_479 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_477,@asemeControlInBodyOfAip,asemeComment_479 skipwhite skipempty
syntax match asemeOperator_477 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_473 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_471,asemeOperator_472,asemeBlock_475
syntax match asemeBlock_475 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_474,@asemeControlInBodyOfAip,asemeComment_476 skipwhite skipempty
syntax region asemeComment_476 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_474,@asemeControlInBodyOfAip,asemeComment_476 skipwhite skipempty
syntax match asemeComment_476 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_474,@asemeControlInBodyOfAip,asemeComment_476 skipwhite skipempty
syntax match asemeOperator_474 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_473 skipwhite skipempty
syntax match asemeOperator_472 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_473 skipwhite skipempty
syntax region asemeComment_473 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_473 skipwhite skipempty
syntax match asemeComment_473 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_473 skipwhite skipempty
syntax region asemePunctuation_471 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_432,asemeNumber_469,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeNumber_469 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_467,asemeComment_470 skipwhite skipempty
syntax region asemeComment_470 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_467,asemeComment_470 skipwhite skipempty
syntax match asemeComment_470 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_467,asemeComment_470 skipwhite skipempty
syntax match asemeOperator_467 /\v\-\>/ contained nextgroup=asemeNumber_465,asemeComment_468 skipwhite skipempty
syntax region asemeComment_468 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_465,asemeComment_468 skipwhite skipempty
syntax match asemeComment_468 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_465,asemeComment_468 skipwhite skipempty
syntax match asemeNumber_465 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_464,asemeComment_466 skipwhite skipempty
syntax region asemeComment_466 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_464,asemeComment_466 skipwhite skipempty
syntax match asemeComment_466 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_464,asemeComment_466 skipwhite skipempty
syntax match asemePunctuation_464 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeDeclaration_432 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_389,asemeOperator_392,asemePunctuation_425,asemeText_426,asemeNumber_427,asemeReference_428,asemeNumber_429,asemeOperator_430,asemePunctuation_431
syntax match asemePunctuation_431 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeOperator_430 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeNumber_429 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeReference_428 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeNumber_427 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeText_426 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemePunctuation_425 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeOperator_392 /\v\#/ contained nextgroup=asemeNumber_391,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_391,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_391,asemeComment_393 skipwhite skipempty
syntax match asemeNumber_391 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeClause_389 /\vevery%(<|>)/ contained nextgroup=asemeNumber_387,asemeComment_390 skipwhite skipempty
syntax region asemeComment_390 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_387,asemeComment_390 skipwhite skipempty
syntax match asemeComment_390 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_387,asemeComment_390 skipwhite skipempty
syntax match asemeNumber_387 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax region asemeComment_388 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeComment_388 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_388 skipwhite skipempty
syntax match asemeDeclaration_385 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_383,asemeComment_386 skipwhite skipempty
syntax region asemeComment_386 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_383,asemeComment_386 skipwhite skipempty
syntax match asemeComment_386 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_383,asemeComment_386 skipwhite skipempty
syntax match asemeName_383 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_382,asemeComment_384 skipwhite skipempty
syntax region asemeComment_384 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_382,asemeComment_384 skipwhite skipempty
syntax match asemeComment_384 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_382,asemeComment_384 skipwhite skipempty
syntax match asemeOperator_382 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_381 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_360,asemeClause_363,asemeClause_366,asemeClause_369,asemeClause_371,asemeClause_372,asemePunctuation_374,asemeOperator_377,asemePunctuation_379,asemeName_380
syntax match asemeName_380 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemePunctuation_379 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeOperator_377 /\v\@/ contained nextgroup=asemeReference_376,asemeComment_378 skipwhite skipempty
syntax region asemeComment_378 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_376,asemeComment_378 skipwhite skipempty
syntax match asemeComment_378 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_376,asemeComment_378 skipwhite skipempty
syntax match asemeReference_376 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemePunctuation_374 /\v\(/ contained nextgroup=asemeName_373,asemeComment_375 skipwhite skipempty
syntax region asemeComment_375 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_373,asemeComment_375 skipwhite skipempty
syntax match asemeComment_375 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_373,asemeComment_375 skipwhite skipempty
syntax match asemeName_373 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeClause_372 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeClause_371 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeClause_369 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_368,asemeComment_370 skipwhite skipempty
syntax region asemeComment_370 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_368,asemeComment_370 skipwhite skipempty
syntax match asemeComment_370 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_368,asemeComment_370 skipwhite skipempty
syntax match asemeNumber_368 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeClause_366 /\vleads%(<|>)/ contained nextgroup=asemeClause_365,asemeComment_367 skipwhite skipempty
syntax region asemeComment_367 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_365,asemeComment_367 skipwhite skipempty
syntax match asemeComment_367 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_365,asemeComment_367 skipwhite skipempty
syntax match asemeClause_365 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeClause_363 /\vor%(<|>)/ contained nextgroup=asemeName_362,asemeComment_364 skipwhite skipempty
syntax region asemeComment_364 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_362,asemeComment_364 skipwhite skipempty
syntax match asemeComment_364 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_362,asemeComment_364 skipwhite skipempty
syntax match asemeName_362 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeClause_360 /\vat%(<|>)/ contained nextgroup=asemeClause_358,asemeComment_361 skipwhite skipempty
syntax region asemeComment_361 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_358,asemeComment_361 skipwhite skipempty
syntax match asemeComment_361 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_358,asemeComment_361 skipwhite skipempty
syntax match asemeClause_358 /\vmost%(<|>)/ contained nextgroup=asemeChoice_355,asemeNumber_357,asemeComment_359 skipwhite skipempty
syntax region asemeComment_359 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_355,asemeNumber_357,asemeComment_359 skipwhite skipempty
syntax match asemeComment_359 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_355,asemeNumber_357,asemeComment_359 skipwhite skipempty
syntax match asemeNumber_357 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeChoice_355 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax region asemeComment_356 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeComment_356 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_356 skipwhite skipempty
syntax match asemeDeclaration_353 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_352,asemeComment_354 skipwhite skipempty
syntax region asemeComment_354 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_352,asemeComment_354 skipwhite skipempty
syntax match asemeComment_354 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_352,asemeComment_354 skipwhite skipempty
syntax match asemeText_352 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_350 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_349,asemeComment_351 skipwhite skipempty
syntax region asemeComment_351 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_349,asemeComment_351 skipwhite skipempty
syntax match asemeComment_351 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_349,asemeComment_351 skipwhite skipempty
syntax match asemeBlock_349 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_224,asemePunctuation_227,asemePunctuation_229,asemePunctuation_347,asemeBlock_348
syntax match asemeBlock_348 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax region asemePunctuation_347 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_231,asemeDeclaration_284,asemeDeclaration_289,asemeDeclaration_310,asemeDeclaration_324,asemeName_346,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_346 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_328,asemePunctuation_332,asemePunctuation_335,asemePunctuation_337,asemeOperator_345
syntax match asemeOperator_345 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemePunctuation_337 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax match asemePunctuation_335 /\v\,/ contained nextgroup=asemeName_334,asemeComment_336 skipwhite skipempty
syntax region asemeComment_336 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_334,asemeComment_336 skipwhite skipempty
syntax match asemeComment_336 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_334,asemeComment_336 skipwhite skipempty
syntax match asemeName_334 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax match asemePunctuation_332 /\v\:/ contained nextgroup=asemeBuiltIn_330,asemeType_331,asemeComment_333 skipwhite skipempty
syntax region asemeComment_333 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_330,asemeType_331,asemeComment_333 skipwhite skipempty
syntax match asemeComment_333 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_330,asemeType_331,asemeComment_333 skipwhite skipempty
syntax match asemeType_331 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax match asemeBuiltIn_330 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax match asemePunctuation_328 /\v\(/ contained nextgroup=asemeName_326,asemeComment_329 skipwhite skipempty
syntax region asemeComment_329 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_326,asemeComment_329 skipwhite skipempty
syntax match asemeComment_329 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_326,asemeComment_329 skipwhite skipempty
syntax match asemeName_326 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax region asemeComment_327 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax match asemeComment_327 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_327 skipwhite skipempty
syntax match asemeDeclaration_324 /\v%(receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_322,asemeComment_325 skipwhite skipempty
syntax region asemeComment_325 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_322,asemeComment_325 skipwhite skipempty
syntax match asemeComment_325 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_322,asemeComment_325 skipwhite skipempty
syntax match asemeReference_322 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax region asemeComment_323 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax match asemeComment_323 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax match asemeReference_321 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_313 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_316,asemeReference_319
syntax match asemeReference_319 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_318,@asemeReceivesInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax region asemeComment_320 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_318,@asemeReceivesInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeComment_320 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_318,@asemeReceivesInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeReference_318 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_313 skipwhite skipempty
syntax match asemePunctuation_316 /\v\,/ contained nextgroup=asemeReference_314,asemeComment_317 skipwhite skipempty
syntax region asemeComment_317 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_314,asemeComment_317 skipwhite skipempty
syntax match asemeComment_317 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_314,asemeComment_317 skipwhite skipempty
syntax match asemeReference_314 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_312,asemeComment_315 skipwhite skipempty
syntax region asemeComment_315 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_312,asemeComment_315 skipwhite skipempty
syntax match asemeComment_315 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_312,asemeComment_315 skipwhite skipempty
syntax match asemeReference_312 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_313 skipwhite skipempty
syntax region asemeComment_313 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_313 skipwhite skipempty
syntax match asemeComment_313 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_313 skipwhite skipempty
syntax match asemeDeclaration_310 /\v%(sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_308,asemeComment_311 skipwhite skipempty
syntax region asemeComment_311 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_308,asemeComment_311 skipwhite skipempty
syntax match asemeComment_311 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_308,asemeComment_311 skipwhite skipempty
syntax match asemeReference_308 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_307,asemeComment_309 skipwhite skipempty
syntax region asemeComment_309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_307,asemeComment_309 skipwhite skipempty
syntax match asemeComment_309 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_307,asemeComment_309 skipwhite skipempty
syntax match asemeReference_307 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_293,asemeClause_296,asemeClause_298,asemePunctuation_302,asemeReference_305
syntax match asemeReference_305 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_304,@asemeSendsInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax region asemeComment_306 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_304,@asemeSendsInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeComment_306 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_304,@asemeSendsInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeReference_304 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax match asemePunctuation_302 /\v\,/ contained nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax region asemeComment_303 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax match asemeComment_303 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax match asemeReference_300 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_299,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_299,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_299,asemeComment_301 skipwhite skipempty
syntax match asemeReference_299 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax match asemeClause_298 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax match asemeClause_296 /\vor%(<|>)/ contained nextgroup=asemeReference_295,asemeComment_297 skipwhite skipempty
syntax region asemeComment_297 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_295,asemeComment_297 skipwhite skipempty
syntax match asemeComment_297 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_295,asemeComment_297 skipwhite skipempty
syntax match asemeReference_295 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax match asemeClause_293 /\vby%(<|>)/ contained nextgroup=asemeReference_291,asemeComment_294 skipwhite skipempty
syntax region asemeComment_294 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_291,asemeComment_294 skipwhite skipempty
syntax match asemeComment_294 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_291,asemeComment_294 skipwhite skipempty
syntax match asemeReference_291 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax region asemeComment_292 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax match asemeComment_292 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_292 skipwhite skipempty
syntax match asemeDeclaration_289 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_287,asemeComment_290 skipwhite skipempty
syntax region asemeComment_290 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_287,asemeComment_290 skipwhite skipempty
syntax match asemeComment_290 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_287,asemeComment_290 skipwhite skipempty
syntax match asemeName_287 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_286,asemeComment_288 skipwhite skipempty
syntax region asemeComment_288 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_286,asemeComment_288 skipwhite skipempty
syntax match asemeComment_288 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_286,asemeComment_288 skipwhite skipempty
syntax match asemeOperator_286 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_284 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_282,asemeComment_285 skipwhite skipempty
syntax region asemeComment_285 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_282,asemeComment_285 skipwhite skipempty
syntax match asemeComment_285 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_282,asemeComment_285 skipwhite skipempty
syntax match asemeName_282 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_280,asemeComment_283 skipwhite skipempty
syntax region asemeComment_283 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_280,asemeComment_283 skipwhite skipempty
syntax match asemeComment_283 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_280,asemeComment_283 skipwhite skipempty
syntax match asemePunctuation_280 /\v\:/ contained nextgroup=asemeBuiltIn_278,asemeType_279,asemeComment_281 skipwhite skipempty
syntax region asemeComment_281 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_278,asemeType_279,asemeComment_281 skipwhite skipempty
syntax match asemeComment_281 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_278,asemeType_279,asemeComment_281 skipwhite skipempty
syntax match asemeType_279 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeBuiltIn_278 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemePunctuation_236,asemeOperator_269,asemeName_274,asemeBuiltIn_276,asemeType_277
syntax match asemeType_277 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeBuiltIn_276 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeName_274 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_272,asemeComment_275 skipwhite skipempty
syntax region asemeComment_275 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_272,asemeComment_275 skipwhite skipempty
syntax match asemeComment_275 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_272,asemeComment_275 skipwhite skipempty
syntax match asemePunctuation_272 /\v\:/ contained nextgroup=asemeBuiltIn_270,asemeType_271,asemeComment_273 skipwhite skipempty
syntax region asemeComment_273 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_270,asemeType_271,asemeComment_273 skipwhite skipempty
syntax match asemeComment_273 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_270,asemeType_271,asemeComment_273 skipwhite skipempty
syntax match asemeType_271 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeBuiltIn_270 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeOperator_269 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemePunctuation_236 /\v\:/ contained nextgroup=asemeBuiltIn_233,asemeType_235,asemeComment_237 skipwhite skipempty
syntax region asemeComment_237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_233,asemeType_235,asemeComment_237 skipwhite skipempty
syntax match asemeComment_237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_233,asemeType_235,asemeComment_237 skipwhite skipempty
syntax match asemeType_235 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeBuiltIn_233 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax region asemeComment_234 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeComment_234 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_234 skipwhite skipempty
syntax match asemeDeclaration_231 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_230,asemeComment_232 skipwhite skipempty
syntax region asemeComment_232 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_230,asemeComment_232 skipwhite skipempty
syntax match asemeComment_232 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_230,asemeComment_232 skipwhite skipempty
syntax match asemeText_230 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_229 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax match asemePunctuation_227 /\v\.\./ contained nextgroup=asemeNumber_226,asemeComment_228 skipwhite skipempty
syntax region asemeComment_228 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_226,asemeComment_228 skipwhite skipempty
syntax match asemeComment_228 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_226,asemeComment_228 skipwhite skipempty
syntax match asemeNumber_226 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax match asemePunctuation_224 /\v\[/ contained nextgroup=asemeNumber_222,asemeComment_225 skipwhite skipempty
syntax region asemeComment_225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_222,asemeComment_225 skipwhite skipempty
syntax match asemeComment_225 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_222,asemeComment_225 skipwhite skipempty
syntax match asemeNumber_222 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax region asemeComment_223 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax match asemeComment_223 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_223 skipwhite skipempty
syntax match asemeDeclaration_220 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_221 skipwhite skipempty
syntax region asemeComment_221 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_221 skipwhite skipempty
syntax match asemeComment_221 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_221 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_219
syntax region asemePunctuation_219 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_199,asemeDeclaration_217,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_217 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_216,asemeComment_218 skipwhite skipempty
syntax region asemeComment_218 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_216,asemeComment_218 skipwhite skipempty
syntax match asemeComment_218 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_216,asemeComment_218 skipwhite skipempty
syntax match asemeName_216 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_203,asemeClause_206,asemeClause_209,asemePunctuation_212,asemeText_214,asemeName_215
syntax match asemeName_215 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemeText_214 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemePunctuation_212 /\v\,/ contained nextgroup=asemeReference_211,asemeComment_213 skipwhite skipempty
syntax region asemeComment_213 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_211,asemeComment_213 skipwhite skipempty
syntax match asemeComment_213 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_211,asemeComment_213 skipwhite skipempty
syntax match asemeReference_211 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemeClause_209 /\vrealises%(<|>)/ contained nextgroup=asemeReference_208,asemeComment_210 skipwhite skipempty
syntax region asemeComment_210 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_208,asemeComment_210 skipwhite skipempty
syntax match asemeComment_210 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_208,asemeComment_210 skipwhite skipempty
syntax match asemeReference_208 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemeClause_206 /\vincludes%(<|>)/ contained nextgroup=asemeReference_205,asemeComment_207 skipwhite skipempty
syntax region asemeComment_207 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_205,asemeComment_207 skipwhite skipempty
syntax match asemeComment_207 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_205,asemeComment_207 skipwhite skipempty
syntax match asemeReference_205 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemeClause_203 /\vby%(<|>)/ contained nextgroup=asemeReference_201,asemeComment_204 skipwhite skipempty
syntax region asemeComment_204 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_201,asemeComment_204 skipwhite skipempty
syntax match asemeComment_204 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_201,asemeComment_204 skipwhite skipempty
syntax match asemeReference_201 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax region asemeComment_202 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemeComment_202 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_202 skipwhite skipempty
syntax match asemeDeclaration_199 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_198,asemeComment_200 skipwhite skipempty
syntax region asemeComment_200 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_198,asemeComment_200 skipwhite skipempty
syntax match asemeComment_200 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_198,asemeComment_200 skipwhite skipempty
syntax match asemeReference_198 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_191 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemePunctuation_192,asemePunctuation_195,asemeReference_197
syntax match asemeReference_197 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_191 skipwhite skipempty
syntax match asemePunctuation_195 /\v\:/ contained nextgroup=asemeChoice_194,asemeComment_196 skipwhite skipempty
syntax region asemeComment_196 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_194,asemeComment_196 skipwhite skipempty
syntax match asemeComment_196 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_194,asemeComment_196 skipwhite skipempty
syntax match asemeChoice_194 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_191 skipwhite skipempty
syntax match asemePunctuation_192 /\v\,/ contained nextgroup=asemeReference_190,asemeComment_193 skipwhite skipempty
syntax region asemeComment_193 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_190,asemeComment_193 skipwhite skipempty
syntax match asemeComment_193 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_190,asemeComment_193 skipwhite skipempty
syntax match asemeReference_190 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_191 skipwhite skipempty
syntax region asemeComment_191 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_191 skipwhite skipempty
syntax match asemeComment_191 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_191 skipwhite skipempty
syntax match asemeDeclaration_188 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_189 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_187
syntax region asemePunctuation_187 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_185,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_185 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_184,asemeComment_186 skipwhite skipempty
syntax region asemeComment_186 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_184,asemeComment_186 skipwhite skipempty
syntax match asemeComment_186 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_184,asemeComment_186 skipwhite skipempty
syntax match asemeBlock_184 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_183 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_181,asemeBlock_182
syntax match asemeBlock_182 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_183 skipwhite skipempty
syntax region asemeComment_183 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_183 skipwhite skipempty
syntax match asemeComment_183 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_183 skipwhite skipempty
syntax region asemePunctuation_181 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_179,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_179 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax region asemeComment_180 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax match asemeComment_180 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax match asemeName_178 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_171,asemePunctuation_174,asemeText_176,asemeName_177
syntax match asemeName_177 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax match asemeText_176 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax match asemePunctuation_174 /\v\,/ contained nextgroup=asemeReference_173,asemeComment_175 skipwhite skipempty
syntax region asemeComment_175 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_173,asemeComment_175 skipwhite skipempty
syntax match asemeComment_175 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_173,asemeComment_175 skipwhite skipempty
syntax match asemeReference_173 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax match asemeClause_171 /\vdepends%(<|>)/ contained nextgroup=asemeClause_169,asemeComment_172 skipwhite skipempty
syntax region asemeComment_172 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_169,asemeComment_172 skipwhite skipempty
syntax match asemeComment_172 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_169,asemeComment_172 skipwhite skipempty
syntax match asemeClause_169 /\von%(<|>)/ contained nextgroup=asemeReference_167,asemeComment_170 skipwhite skipempty
syntax region asemeComment_170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_167,asemeComment_170 skipwhite skipempty
syntax match asemeComment_170 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_167,asemeComment_170 skipwhite skipempty
syntax match asemeReference_167 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax region asemeComment_168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax match asemeComment_168 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_168 skipwhite skipempty
syntax match asemeDeclaration_165 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_163,asemeComment_166 skipwhite skipempty
syntax region asemeComment_166 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_163,asemeComment_166 skipwhite skipempty
syntax match asemeComment_166 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_163,asemeComment_166 skipwhite skipempty
syntax match asemeName_163 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_162,asemeComment_164 skipwhite skipempty
syntax region asemeComment_164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_162,asemeComment_164 skipwhite skipempty
syntax match asemeComment_164 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_162,asemeComment_164 skipwhite skipempty
syntax match asemePunctuation_162 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_146,asemePunctuation_152,asemePunctuation_154,asemeBuiltIn_156,asemeType_158,asemeName_160
syntax match asemeName_160 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_159,asemeComment_161 skipwhite skipempty
syntax region asemeComment_161 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_159,asemeComment_161 skipwhite skipempty
syntax match asemeComment_161 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_159,asemeComment_161 skipwhite skipempty
syntax match asemePunctuation_159 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax match asemeType_158 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_155,asemeComment_157 skipwhite skipempty
syntax match asemeBuiltIn_156 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_155,asemeComment_157 skipwhite skipempty
syntax region asemeComment_157 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_155,asemeComment_157 skipwhite skipempty
syntax match asemeComment_157 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_155,asemeComment_157 skipwhite skipempty
syntax match asemeName_155 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax match asemePunctuation_154 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax match asemePunctuation_152 /\v\,/ contained nextgroup=asemeBuiltIn_149,asemeType_151,asemeComment_153 skipwhite skipempty
syntax region asemeComment_153 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_149,asemeType_151,asemeComment_153 skipwhite skipempty
syntax match asemeComment_153 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_149,asemeType_151,asemeComment_153 skipwhite skipempty
syntax match asemeType_151 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_148,asemeComment_150 skipwhite skipempty
syntax match asemeBuiltIn_149 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_148,asemeComment_150 skipwhite skipempty
syntax region asemeComment_150 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_148,asemeComment_150 skipwhite skipempty
syntax match asemeComment_150 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_148,asemeComment_150 skipwhite skipempty
syntax match asemeName_148 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax match asemePunctuation_146 /\v\)/ contained nextgroup=asemePunctuation_144,asemeComment_147 skipwhite skipempty
syntax region asemeComment_147 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_144,asemeComment_147 skipwhite skipempty
syntax match asemeComment_147 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_144,asemeComment_147 skipwhite skipempty
syntax match asemePunctuation_144 /\v\:/ contained nextgroup=asemeBuiltIn_141,asemeType_143,asemeComment_145 skipwhite skipempty
syntax region asemeComment_145 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_141,asemeType_143,asemeComment_145 skipwhite skipempty
syntax match asemeComment_145 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_141,asemeType_143,asemeComment_145 skipwhite skipempty
syntax match asemeType_143 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_139,asemeComment_142 skipwhite skipempty
syntax match asemeBuiltIn_141 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_139,asemeComment_142 skipwhite skipempty
syntax region asemeComment_142 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_139,asemeComment_142 skipwhite skipempty
syntax match asemeComment_142 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_139,asemeComment_142 skipwhite skipempty
syntax match asemeOperator_139 /\v\=%(\=)@!/ contained nextgroup=asemeText_137,asemeComment_140 skipwhite skipempty
syntax region asemeComment_140 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_137,asemeComment_140 skipwhite skipempty
syntax match asemeComment_140 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_137,asemeComment_140 skipwhite skipempty
syntax match asemeText_137 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax region asemeComment_138 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax match asemeComment_138 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_138 skipwhite skipempty
syntax match asemeDeclaration_135 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_134,asemeComment_136 skipwhite skipempty
syntax region asemeComment_136 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_134,asemeComment_136 skipwhite skipempty
syntax match asemeComment_136 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_134,asemeComment_136 skipwhite skipempty
syntax match asemeBlock_134 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_112,asemeClause_115,asemePunctuation_132,asemeBlock_133
syntax match asemeBlock_133 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax region asemePunctuation_132 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_130,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_130 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_129,asemeComment_131 skipwhite skipempty
syntax region asemeComment_131 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_129,asemeComment_131 skipwhite skipempty
syntax match asemeComment_131 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_129,asemeComment_131 skipwhite skipempty
syntax match asemeReference_129 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_119,asemeClause_122,asemeChoice_124,asemePunctuation_126,asemeReference_128
syntax match asemeReference_128 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax match asemePunctuation_126 /\v\,/ contained nextgroup=asemeReference_125,asemeComment_127 skipwhite skipempty
syntax region asemeComment_127 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_125,asemeComment_127 skipwhite skipempty
syntax match asemeComment_127 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_125,asemeComment_127 skipwhite skipempty
syntax match asemeReference_125 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax match asemeChoice_124 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax match asemeClause_122 /\vevery%(<|>)/ contained nextgroup=asemeNumber_121,asemeComment_123 skipwhite skipempty
syntax region asemeComment_123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_121,asemeComment_123 skipwhite skipempty
syntax match asemeComment_123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_121,asemeComment_123 skipwhite skipempty
syntax match asemeNumber_121 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax match asemeClause_119 /\vfrom%(<|>)/ contained nextgroup=asemeReference_117,asemeComment_120 skipwhite skipempty
syntax region asemeComment_120 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_117,asemeComment_120 skipwhite skipempty
syntax match asemeComment_120 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_117,asemeComment_120 skipwhite skipempty
syntax match asemeReference_117 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax region asemeComment_118 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax match asemeComment_118 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_118 skipwhite skipempty
syntax match asemeClause_115 /\vradio%(<|>)/ contained nextgroup=asemeNumber_114,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_114,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_114,asemeComment_116 skipwhite skipempty
syntax match asemeNumber_114 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax match asemeClause_112 /\vunder%(<|>)/ contained nextgroup=asemeReference_110,asemeComment_113 skipwhite skipempty
syntax region asemeComment_113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_110,asemeComment_113 skipwhite skipempty
syntax match asemeComment_113 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_110,asemeComment_113 skipwhite skipempty
syntax match asemeReference_110 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax region asemeComment_111 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax match asemeComment_111 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax match asemeDeclaration_108 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_107,asemeComment_109 skipwhite skipempty
syntax region asemeComment_109 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_107,asemeComment_109 skipwhite skipempty
syntax match asemeComment_109 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_107,asemeComment_109 skipwhite skipempty
syntax match asemeBlock_107 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_106 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_104,asemeBlock_105
syntax match asemeBlock_105 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_106 skipwhite skipempty
syntax region asemeComment_106 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_106 skipwhite skipempty
syntax match asemeComment_106 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_106 skipwhite skipempty
syntax region asemePunctuation_104 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_98,asemeBuiltIn_101,asemeType_103,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeType_103 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax match asemeBuiltIn_101 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax region asemeComment_102 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax match asemeComment_102 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax match asemeName_100 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax match asemeDeclaration_98 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_95,asemeType_97,asemeComment_99 skipwhite skipempty
syntax region asemeComment_99 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_95,asemeType_97,asemeComment_99 skipwhite skipempty
syntax match asemeComment_99 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_95,asemeType_97,asemeComment_99 skipwhite skipempty
syntax match asemeType_97 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax match asemeBuiltIn_95 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax region asemeComment_96 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax match asemeComment_96 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax match asemeName_94 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_86,asemePunctuation_88,asemeBuiltIn_90,asemeType_92,asemeName_93
syntax match asemeName_93 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax match asemeType_92 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_89,asemeComment_91 skipwhite skipempty
syntax match asemeBuiltIn_90 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_89,asemeComment_91 skipwhite skipempty
syntax region asemeComment_91 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_89,asemeComment_91 skipwhite skipempty
syntax match asemeComment_91 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_89,asemeComment_91 skipwhite skipempty
syntax match asemeName_89 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax match asemePunctuation_88 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax match asemeOperator_86 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_84,asemeComment_87 skipwhite skipempty
syntax region asemeComment_87 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_84,asemeComment_87 skipwhite skipempty
syntax match asemeComment_87 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_84,asemeComment_87 skipwhite skipempty
syntax match asemeNumber_84 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax region asemeComment_85 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax match asemeComment_85 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_85 skipwhite skipempty
syntax match asemeDeclaration_82 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_81,asemeComment_83 skipwhite skipempty
syntax region asemeComment_83 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_81,asemeComment_83 skipwhite skipempty
syntax match asemeComment_83 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_81,asemeComment_83 skipwhite skipempty
syntax match asemeBlock_81 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_80 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_78,asemeBlock_79
syntax match asemeBlock_79 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_80 skipwhite skipempty
syntax region asemeComment_80 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_80 skipwhite skipempty
syntax match asemeComment_80 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_80 skipwhite skipempty
syntax region asemePunctuation_78 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_77,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_77 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_73 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_74,asemePunctuation_76
syntax match asemePunctuation_76 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_73 skipwhite skipempty
syntax match asemeOperator_74 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_72,asemeComment_75 skipwhite skipempty
syntax region asemeComment_75 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_72,asemeComment_75 skipwhite skipempty
syntax match asemeComment_75 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_72,asemeComment_75 skipwhite skipempty
syntax match asemeNumber_72 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_73 skipwhite skipempty
syntax region asemeComment_73 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_73 skipwhite skipempty
syntax match asemeComment_73 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_73 skipwhite skipempty
syntax match asemeDeclaration_70 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_68,asemeComment_71 skipwhite skipempty
syntax region asemeComment_71 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_68,asemeComment_71 skipwhite skipempty
syntax match asemeComment_71 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_68,asemeComment_71 skipwhite skipempty
syntax match asemeName_68 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_67,asemeComment_69 skipwhite skipempty
syntax region asemeComment_69 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_67,asemeComment_69 skipwhite skipempty
syntax match asemeComment_69 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_67,asemeComment_69 skipwhite skipempty
syntax match asemeOperator_67 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_910,asemeClause_913,asemeText_915,asemeNumber_916,asemeTruth_917,asemeLogic_918,asemeClause_919,asemeClause_920,asemeClause_921,asemeClause_922,asemeClause_923,asemeClause_924,asemeClause_925,asemeClause_926,asemeClause_927,asemeClause_928,asemeClause_929,asemeClause_930,asemeCall_931,asemeReference_932,asemeOperator_933,asemePunctuation_934
syntax match asemePunctuation_934 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeOperator_933 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeReference_932 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeCall_931 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_930 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_929 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_928 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_927 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_926 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_925 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_924 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_923 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_922 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_921 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_920 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_919 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeLogic_918 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeTruth_917 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeNumber_916 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeText_915 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeClause_913 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_912,asemeComment_914 skipwhite skipempty
syntax region asemeComment_914 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_912,asemeComment_914 skipwhite skipempty
syntax match asemeComment_914 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_912,asemeComment_914 skipwhite skipempty
syntax match asemeReference_912 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_905,asemeComment_907 skipwhite skipempty
syntax match asemeClause_910 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_908,asemeComment_911 skipwhite skipempty
syntax region asemeComment_911 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_908,asemeComment_911 skipwhite skipempty
syntax match asemeComment_911 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_908,asemeComment_911 skipwhite skipempty
syntax match asemeReference_908 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_906,asemeComment_909 skipwhite skipempty
syntax region asemeComment_909 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_906,asemeComment_909 skipwhite skipempty
syntax match asemeComment_909 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_906,asemeComment_909 skipwhite skipempty
syntax match asemeReference_906 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_905,asemeComment_907 skipwhite skipempty
syntax region asemeComment_907 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_905,asemeComment_907 skipwhite skipempty
syntax match asemeComment_907 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_905,asemeComment_907 skipwhite skipempty
syntax region asemePunctuation_905 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax region asemeComment_904 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax match asemeComment_904 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_904 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_847,asemeClause_850,asemeText_852,asemeNumber_853,asemeTruth_854,asemeLogic_855,asemeClause_856,asemeClause_857,asemeClause_858,asemeClause_859,asemeClause_860,asemeClause_861,asemeClause_862,asemeClause_863,asemeClause_864,asemeClause_865,asemeClause_866,asemeClause_867,asemeCall_868,asemeReference_869,asemeOperator_870,asemePunctuation_871
syntax match asemePunctuation_871 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeOperator_870 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeReference_869 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeCall_868 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_867 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_866 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_865 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_864 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_863 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_862 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_861 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_860 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_859 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_858 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_857 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_856 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeLogic_855 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeTruth_854 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeNumber_853 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeText_852 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeClause_850 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_849,asemeComment_851 skipwhite skipempty
syntax region asemeComment_851 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_849,asemeComment_851 skipwhite skipempty
syntax match asemeComment_851 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_849,asemeComment_851 skipwhite skipempty
syntax match asemeReference_849 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax match asemeClause_847 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_845,asemeComment_848 skipwhite skipempty
syntax region asemeComment_848 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_845,asemeComment_848 skipwhite skipempty
syntax match asemeComment_848 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_845,asemeComment_848 skipwhite skipempty
syntax match asemeReference_845 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_843,asemeComment_846 skipwhite skipempty
syntax region asemeComment_846 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_843,asemeComment_846 skipwhite skipempty
syntax match asemeComment_846 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_843,asemeComment_846 skipwhite skipempty
syntax match asemeReference_843 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax region asemeComment_844 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax match asemeComment_844 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax region asemePunctuation_842 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax region asemeComment_841 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax match asemeComment_841 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_841 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_806,asemeClause_809,asemeText_811,asemeNumber_812,asemeTruth_813,asemeLogic_814,asemeClause_815,asemeClause_816,asemeClause_817,asemeClause_818,asemeClause_819,asemeClause_820,asemeClause_821,asemeClause_822,asemeClause_823,asemeClause_824,asemeClause_825,asemeClause_826,asemeCall_827,asemeReference_828,asemeOperator_829,asemePunctuation_830
syntax match asemePunctuation_830 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeOperator_829 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeReference_828 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeCall_827 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_826 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_825 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_824 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_823 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_822 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_821 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_820 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_819 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_818 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_817 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_816 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_815 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeLogic_814 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeTruth_813 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeNumber_812 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeText_811 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeClause_809 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_808,asemeComment_810 skipwhite skipempty
syntax region asemeComment_810 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_808,asemeComment_810 skipwhite skipempty
syntax match asemeComment_810 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_808,asemeComment_810 skipwhite skipempty
syntax match asemeReference_808 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_801,asemeComment_803 skipwhite skipempty
syntax match asemeClause_806 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_804,asemeComment_807 skipwhite skipempty
syntax region asemeComment_807 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_804,asemeComment_807 skipwhite skipempty
syntax match asemeComment_807 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_804,asemeComment_807 skipwhite skipempty
syntax match asemeReference_804 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_802,asemeComment_805 skipwhite skipempty
syntax region asemeComment_805 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_802,asemeComment_805 skipwhite skipempty
syntax match asemeComment_805 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_802,asemeComment_805 skipwhite skipempty
syntax match asemeReference_802 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_801,asemeComment_803 skipwhite skipempty
syntax region asemeComment_803 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_801,asemeComment_803 skipwhite skipempty
syntax match asemeComment_803 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_801,asemeComment_803 skipwhite skipempty
syntax region asemePunctuation_801 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax region asemeComment_800 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax match asemeComment_800 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_800 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_622,asemeNumber_624,asemeReference_625,asemeNumber_626,asemeOperator_627,asemePunctuation_628
syntax match asemePunctuation_628 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemeOperator_627 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemeNumber_626 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemeReference_625 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemeNumber_624 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemeText_622 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax region asemeComment_623 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax match asemeComment_623 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_623 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_563,asemeClause_566,asemeText_568,asemeNumber_569,asemeTruth_570,asemeLogic_571,asemeClause_572,asemeClause_573,asemeClause_574,asemeClause_575,asemeClause_576,asemeClause_577,asemeClause_578,asemeClause_579,asemeClause_580,asemeClause_581,asemeClause_582,asemeClause_583,asemeCall_584,asemeReference_585,asemeOperator_586,asemePunctuation_587
syntax match asemePunctuation_587 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeOperator_586 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeReference_585 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeCall_584 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_583 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_582 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_581 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_580 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_579 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_578 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_577 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_576 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_575 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_574 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_573 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_572 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeLogic_571 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeTruth_570 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeNumber_569 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeText_568 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeClause_566 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax region asemeComment_567 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax match asemeComment_567 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax match asemeReference_565 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_558,asemeComment_560 skipwhite skipempty
syntax match asemeClause_563 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_561,asemeComment_564 skipwhite skipempty
syntax region asemeComment_564 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_561,asemeComment_564 skipwhite skipempty
syntax match asemeComment_564 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_561,asemeComment_564 skipwhite skipempty
syntax match asemeReference_561 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_559,asemeComment_562 skipwhite skipempty
syntax region asemeComment_562 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_559,asemeComment_562 skipwhite skipempty
syntax match asemeComment_562 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_559,asemeComment_562 skipwhite skipempty
syntax match asemeReference_559 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_558,asemeComment_560 skipwhite skipempty
syntax region asemeComment_560 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_558,asemeComment_560 skipwhite skipempty
syntax match asemeComment_560 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_558,asemeComment_560 skipwhite skipempty
syntax region asemePunctuation_558 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax region asemeComment_557 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax match asemeComment_557 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_557 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_439,asemeClause_442,asemeText_444,asemeNumber_445,asemeTruth_446,asemeLogic_447,asemeClause_448,asemeClause_449,asemeClause_450,asemeClause_451,asemeClause_452,asemeClause_453,asemeClause_454,asemeClause_455,asemeClause_456,asemeClause_457,asemeClause_458,asemeClause_459,asemeCall_460,asemeReference_461,asemeOperator_462,asemePunctuation_463
syntax match asemePunctuation_463 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeOperator_462 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeReference_461 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeCall_460 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_459 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_458 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_457 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_456 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_455 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_454 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_453 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_452 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_451 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_450 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_449 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_448 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeLogic_447 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeTruth_446 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeNumber_445 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeText_444 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeClause_442 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax region asemeComment_443 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax match asemeComment_443 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax match asemeReference_441 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_434,asemeComment_436 skipwhite skipempty
syntax match asemeClause_439 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_437,asemeComment_440 skipwhite skipempty
syntax region asemeComment_440 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_437,asemeComment_440 skipwhite skipempty
syntax match asemeComment_440 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_437,asemeComment_440 skipwhite skipempty
syntax match asemeReference_437 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_435,asemeComment_438 skipwhite skipempty
syntax region asemeComment_438 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_435,asemeComment_438 skipwhite skipempty
syntax match asemeComment_438 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_435,asemeComment_438 skipwhite skipempty
syntax match asemeReference_435 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_434,asemeComment_436 skipwhite skipempty
syntax region asemeComment_436 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_434,asemeComment_436 skipwhite skipempty
syntax match asemeComment_436 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_434,asemeComment_436 skipwhite skipempty
syntax region asemePunctuation_434 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax region asemeComment_433 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax match asemeComment_433 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_433 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_400,asemeClause_403,asemeText_405,asemeNumber_406,asemeTruth_407,asemeLogic_408,asemeClause_409,asemeClause_410,asemeClause_411,asemeClause_412,asemeClause_413,asemeClause_414,asemeClause_415,asemeClause_416,asemeClause_417,asemeClause_418,asemeClause_419,asemeClause_420,asemeCall_421,asemeReference_422,asemeOperator_423,asemePunctuation_424
syntax match asemePunctuation_424 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeOperator_423 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeReference_422 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeCall_421 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_420 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_419 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_418 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_417 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_416 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_415 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_414 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_413 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_412 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_411 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_410 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_409 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeLogic_408 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeTruth_407 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeNumber_406 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeText_405 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeClause_403 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_402,asemeComment_404 skipwhite skipempty
syntax region asemeComment_404 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_402,asemeComment_404 skipwhite skipempty
syntax match asemeComment_404 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_402,asemeComment_404 skipwhite skipempty
syntax match asemeReference_402 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_395,asemeComment_397 skipwhite skipempty
syntax match asemeClause_400 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax region asemeComment_401 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax match asemeComment_401 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax match asemeReference_398 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_396,asemeComment_399 skipwhite skipempty
syntax region asemeComment_399 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_396,asemeComment_399 skipwhite skipempty
syntax match asemeComment_399 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_396,asemeComment_399 skipwhite skipempty
syntax match asemeReference_396 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_395,asemeComment_397 skipwhite skipempty
syntax region asemeComment_397 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_395,asemeComment_397 skipwhite skipempty
syntax match asemeComment_397 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_395,asemeComment_397 skipwhite skipempty
syntax region asemePunctuation_395 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax region asemeComment_394 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax match asemeComment_394 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_394 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_338,asemeNumber_340,asemeReference_341,asemeNumber_342,asemeOperator_343,asemePunctuation_344
syntax match asemePunctuation_344 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemeOperator_343 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemeNumber_342 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemeReference_341 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemeNumber_340 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemeText_338 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax region asemeComment_339 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax match asemeComment_339 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_339 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_244,asemeClause_247,asemeText_249,asemeNumber_250,asemeTruth_251,asemeLogic_252,asemeClause_253,asemeClause_254,asemeClause_255,asemeClause_256,asemeClause_257,asemeClause_258,asemeClause_259,asemeClause_260,asemeClause_261,asemeClause_262,asemeClause_263,asemeClause_264,asemeCall_265,asemeReference_266,asemeOperator_267,asemePunctuation_268
syntax match asemePunctuation_268 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeOperator_267 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeReference_266 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeCall_265 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_264 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_263 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_262 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_261 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_260 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_259 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_258 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_257 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_256 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_255 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_254 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_253 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeLogic_252 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeTruth_251 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeNumber_250 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeText_249 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeClause_247 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_246,asemeComment_248 skipwhite skipempty
syntax region asemeComment_248 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_246,asemeComment_248 skipwhite skipempty
syntax match asemeComment_248 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_246,asemeComment_248 skipwhite skipempty
syntax match asemeReference_246 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_239,asemeComment_241 skipwhite skipempty
syntax match asemeClause_244 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_242,asemeComment_245 skipwhite skipempty
syntax region asemeComment_245 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_242,asemeComment_245 skipwhite skipempty
syntax match asemeComment_245 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_242,asemeComment_245 skipwhite skipempty
syntax match asemeReference_242 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_240,asemeComment_243 skipwhite skipempty
syntax region asemeComment_243 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_240,asemeComment_243 skipwhite skipempty
syntax match asemeComment_243 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_240,asemeComment_243 skipwhite skipempty
syntax match asemeReference_240 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_239,asemeComment_241 skipwhite skipempty
syntax region asemeComment_241 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_239,asemeComment_241 skipwhite skipempty
syntax match asemeComment_241 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_239,asemeComment_241 skipwhite skipempty
syntax region asemePunctuation_239 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax region asemeComment_238 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax match asemeComment_238 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_238 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_42,asemeClause_45,asemeText_47,asemeNumber_48,asemeTruth_49,asemeLogic_50,asemeClause_51,asemeClause_52,asemeClause_53,asemeClause_54,asemeClause_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeClause_59,asemeClause_60,asemeClause_61,asemeClause_62,asemeCall_63,asemeReference_64,asemeOperator_65,asemePunctuation_66
syntax match asemePunctuation_66 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeOperator_65 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeReference_64 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeCall_63 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_51 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeLogic_50 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeTruth_49 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeNumber_48 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeText_47 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_45 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_44,asemeComment_46 skipwhite skipempty
syntax region asemeComment_46 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_44,asemeComment_46 skipwhite skipempty
syntax match asemeComment_46 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_44,asemeComment_46 skipwhite skipempty
syntax match asemeReference_44 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_37,asemeComment_39 skipwhite skipempty
syntax match asemeClause_42 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_40,asemeComment_43 skipwhite skipempty
syntax region asemeComment_43 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_40,asemeComment_43 skipwhite skipempty
syntax match asemeComment_43 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_40,asemeComment_43 skipwhite skipempty
syntax match asemeReference_40 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_38,asemeComment_41 skipwhite skipempty
syntax region asemeComment_41 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_38,asemeComment_41 skipwhite skipempty
syntax match asemeComment_41 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_38,asemeComment_41 skipwhite skipempty
syntax match asemeReference_38 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_37,asemeComment_39 skipwhite skipempty
syntax region asemeComment_39 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_37,asemeComment_39 skipwhite skipempty
syntax match asemeComment_39 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_37,asemeComment_39 skipwhite skipempty
syntax region asemePunctuation_37 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax region asemeComment_36 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeComment_36 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax cluster asemeContentOfAMessage contains=asemeText_10,asemeNumber_11,asemeTruth_12,asemeLogic_13,asemeClause_14,asemeClause_15,asemeClause_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeClause_23,asemeClause_24,asemeClause_25,asemeCall_26,asemeReference_27,asemeOperator_28,asemePunctuation_29,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_29 /\v%([^ \t{}])@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_28 /\v%([^ \t{}])@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_27 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeCall_26 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained
syntax match asemeClause_25 /\v%([^ \t{}])@=write_messages%(<|>)%(\_s*\.)@=/ contained
syntax match asemeClause_24 /\v%([^ \t{}])@=read_messages%(<|>)%(\_s*\()@!/ contained
syntax match asemeClause_23 /\v%([^ \t{}])@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_22 /\v%([^ \t{}])@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_21 /\v%([^ \t{}])@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_20 /\v%([^ \t{}])@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained
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
highlight default link asemeBlock_105 asemeBlock
highlight default link asemeBlock_107 asemeBlock
highlight default link asemeBlock_133 asemeBlock
highlight default link asemeBlock_134 asemeBlock
highlight default link asemeBlock_182 asemeBlock
highlight default link asemeBlock_184 asemeBlock
highlight default link asemeBlock_348 asemeBlock
highlight default link asemeBlock_349 asemeBlock
highlight default link asemeBlock_475 asemeBlock
highlight default link asemeBlock_478 asemeBlock
highlight default link asemeBlock_483 asemeBlock
highlight default link asemeBlock_485 asemeBlock
highlight default link asemeBlock_488 asemeBlock
highlight default link asemeBlock_744 asemeBlock
highlight default link asemeBlock_746 asemeBlock
highlight default link asemeBlock_752 asemeBlock
highlight default link asemeBlock_755 asemeBlock
highlight default link asemeBlock_760 asemeBlock
highlight default link asemeBlock_761 asemeBlock
highlight default link asemeBlock_766 asemeBlock
highlight default link asemeBlock_79 asemeBlock
highlight default link asemeBlock_81 asemeBlock
highlight default link asemeBlock_899 asemeBlock
highlight default link asemeBlock_901 asemeBlock
highlight default link asemeBlock_961 asemeBlock
highlight default link asemeBlock_963 asemeBlock
highlight default link asemeBuiltIn_101 asemeBuiltIn
highlight default link asemeBuiltIn_141 asemeBuiltIn
highlight default link asemeBuiltIn_149 asemeBuiltIn
highlight default link asemeBuiltIn_156 asemeBuiltIn
highlight default link asemeBuiltIn_233 asemeBuiltIn
highlight default link asemeBuiltIn_270 asemeBuiltIn
highlight default link asemeBuiltIn_276 asemeBuiltIn
highlight default link asemeBuiltIn_278 asemeBuiltIn
highlight default link asemeBuiltIn_330 asemeBuiltIn
highlight default link asemeBuiltIn_552 asemeBuiltIn
highlight default link asemeBuiltIn_589 asemeBuiltIn
highlight default link asemeBuiltIn_595 asemeBuiltIn
highlight default link asemeBuiltIn_597 asemeBuiltIn
highlight default link asemeBuiltIn_614 asemeBuiltIn
highlight default link asemeBuiltIn_666 asemeBuiltIn
highlight default link asemeBuiltIn_674 asemeBuiltIn
highlight default link asemeBuiltIn_836 asemeBuiltIn
highlight default link asemeBuiltIn_873 asemeBuiltIn
highlight default link asemeBuiltIn_879 asemeBuiltIn
highlight default link asemeBuiltIn_881 asemeBuiltIn
highlight default link asemeBuiltIn_90 asemeBuiltIn
highlight default link asemeBuiltIn_95 asemeBuiltIn
highlight default link asemeCall_26 asemeCall
highlight default link asemeCall_265 asemeCall
highlight default link asemeCall_421 asemeCall
highlight default link asemeCall_460 asemeCall
highlight default link asemeCall_584 asemeCall
highlight default link asemeCall_63 asemeCall
highlight default link asemeCall_827 asemeCall
highlight default link asemeCall_868 asemeCall
highlight default link asemeCall_931 asemeCall
highlight default link asemeChoice_124 asemeChoice
highlight default link asemeChoice_194 asemeChoice
highlight default link asemeChoice_355 asemeChoice
highlight default link asemeChoice_636 asemeChoice
highlight default link asemeChoice_650 asemeChoice
highlight default link asemeChoice_681 asemeChoice
highlight default link asemeChoice_695 asemeChoice
highlight default link asemeChoice_709 asemeChoice
highlight default link asemeChoice_726 asemeChoice
highlight default link asemeChoice_775 asemeChoice
highlight default link asemeChoice_779 asemeChoice
highlight default link asemeChoice_787 asemeChoice
highlight default link asemeClause_112 asemeClause
highlight default link asemeClause_115 asemeClause
highlight default link asemeClause_119 asemeClause
highlight default link asemeClause_122 asemeClause
highlight default link asemeClause_14 asemeClause
highlight default link asemeClause_15 asemeClause
highlight default link asemeClause_16 asemeClause
highlight default link asemeClause_169 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_171 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_203 asemeClause
highlight default link asemeClause_206 asemeClause
highlight default link asemeClause_209 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_24 asemeClause
highlight default link asemeClause_244 asemeClause
highlight default link asemeClause_247 asemeClause
highlight default link asemeClause_25 asemeClause
highlight default link asemeClause_253 asemeClause
highlight default link asemeClause_254 asemeClause
highlight default link asemeClause_255 asemeClause
highlight default link asemeClause_256 asemeClause
highlight default link asemeClause_257 asemeClause
highlight default link asemeClause_258 asemeClause
highlight default link asemeClause_259 asemeClause
highlight default link asemeClause_260 asemeClause
highlight default link asemeClause_261 asemeClause
highlight default link asemeClause_262 asemeClause
highlight default link asemeClause_263 asemeClause
highlight default link asemeClause_264 asemeClause
highlight default link asemeClause_293 asemeClause
highlight default link asemeClause_296 asemeClause
highlight default link asemeClause_298 asemeClause
highlight default link asemeClause_358 asemeClause
highlight default link asemeClause_360 asemeClause
highlight default link asemeClause_363 asemeClause
highlight default link asemeClause_365 asemeClause
highlight default link asemeClause_366 asemeClause
highlight default link asemeClause_369 asemeClause
highlight default link asemeClause_371 asemeClause
highlight default link asemeClause_372 asemeClause
highlight default link asemeClause_389 asemeClause
highlight default link asemeClause_400 asemeClause
highlight default link asemeClause_403 asemeClause
highlight default link asemeClause_409 asemeClause
highlight default link asemeClause_410 asemeClause
highlight default link asemeClause_411 asemeClause
highlight default link asemeClause_412 asemeClause
highlight default link asemeClause_413 asemeClause
highlight default link asemeClause_414 asemeClause
highlight default link asemeClause_415 asemeClause
highlight default link asemeClause_416 asemeClause
highlight default link asemeClause_417 asemeClause
highlight default link asemeClause_418 asemeClause
highlight default link asemeClause_419 asemeClause
highlight default link asemeClause_42 asemeClause
highlight default link asemeClause_420 asemeClause
highlight default link asemeClause_439 asemeClause
highlight default link asemeClause_442 asemeClause
highlight default link asemeClause_448 asemeClause
highlight default link asemeClause_449 asemeClause
highlight default link asemeClause_45 asemeClause
highlight default link asemeClause_450 asemeClause
highlight default link asemeClause_451 asemeClause
highlight default link asemeClause_452 asemeClause
highlight default link asemeClause_453 asemeClause
highlight default link asemeClause_454 asemeClause
highlight default link asemeClause_455 asemeClause
highlight default link asemeClause_456 asemeClause
highlight default link asemeClause_457 asemeClause
highlight default link asemeClause_458 asemeClause
highlight default link asemeClause_459 asemeClause
highlight default link asemeClause_490 asemeClause
highlight default link asemeClause_506 asemeClause
highlight default link asemeClause_509 asemeClause
highlight default link asemeClause_51 asemeClause
highlight default link asemeClause_52 asemeClause
highlight default link asemeClause_53 asemeClause
highlight default link asemeClause_54 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_563 asemeClause
highlight default link asemeClause_566 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_572 asemeClause
highlight default link asemeClause_573 asemeClause
highlight default link asemeClause_574 asemeClause
highlight default link asemeClause_575 asemeClause
highlight default link asemeClause_576 asemeClause
highlight default link asemeClause_577 asemeClause
highlight default link asemeClause_578 asemeClause
highlight default link asemeClause_579 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_580 asemeClause
highlight default link asemeClause_581 asemeClause
highlight default link asemeClause_582 asemeClause
highlight default link asemeClause_583 asemeClause
highlight default link asemeClause_59 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_639 asemeClause
highlight default link asemeClause_642 asemeClause
highlight default link asemeClause_645 asemeClause
highlight default link asemeClause_648 asemeClause
highlight default link asemeClause_651 asemeClause
highlight default link asemeClause_654 asemeClause
highlight default link asemeClause_657 asemeClause
highlight default link asemeClause_660 asemeClause
highlight default link asemeClause_663 asemeClause
highlight default link asemeClause_665 asemeClause
highlight default link asemeClause_698 asemeClause
highlight default link asemeClause_701 asemeClause
highlight default link asemeClause_704 asemeClause
highlight default link asemeClause_707 asemeClause
highlight default link asemeClause_710 asemeClause
highlight default link asemeClause_713 asemeClause
highlight default link asemeClause_716 asemeClause
highlight default link asemeClause_719 asemeClause
highlight default link asemeClause_722 asemeClause
highlight default link asemeClause_724 asemeClause
highlight default link asemeClause_762 asemeClause
highlight default link asemeClause_771 asemeClause
highlight default link asemeClause_806 asemeClause
highlight default link asemeClause_809 asemeClause
highlight default link asemeClause_815 asemeClause
highlight default link asemeClause_816 asemeClause
highlight default link asemeClause_817 asemeClause
highlight default link asemeClause_818 asemeClause
highlight default link asemeClause_819 asemeClause
highlight default link asemeClause_820 asemeClause
highlight default link asemeClause_821 asemeClause
highlight default link asemeClause_822 asemeClause
highlight default link asemeClause_823 asemeClause
highlight default link asemeClause_824 asemeClause
highlight default link asemeClause_825 asemeClause
highlight default link asemeClause_826 asemeClause
highlight default link asemeClause_847 asemeClause
highlight default link asemeClause_850 asemeClause
highlight default link asemeClause_856 asemeClause
highlight default link asemeClause_857 asemeClause
highlight default link asemeClause_858 asemeClause
highlight default link asemeClause_859 asemeClause
highlight default link asemeClause_860 asemeClause
highlight default link asemeClause_861 asemeClause
highlight default link asemeClause_862 asemeClause
highlight default link asemeClause_863 asemeClause
highlight default link asemeClause_864 asemeClause
highlight default link asemeClause_865 asemeClause
highlight default link asemeClause_866 asemeClause
highlight default link asemeClause_867 asemeClause
highlight default link asemeClause_910 asemeClause
highlight default link asemeClause_913 asemeClause
highlight default link asemeClause_919 asemeClause
highlight default link asemeClause_920 asemeClause
highlight default link asemeClause_921 asemeClause
highlight default link asemeClause_922 asemeClause
highlight default link asemeClause_923 asemeClause
highlight default link asemeClause_924 asemeClause
highlight default link asemeClause_925 asemeClause
highlight default link asemeClause_926 asemeClause
highlight default link asemeClause_927 asemeClause
highlight default link asemeClause_928 asemeClause
highlight default link asemeClause_929 asemeClause
highlight default link asemeClause_930 asemeClause
highlight default link asemeClause_938 asemeClause
highlight default link asemeComment_1002 asemeComment
highlight default link asemeComment_1005 asemeComment
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_106 asemeComment
highlight default link asemeComment_109 asemeComment
highlight default link asemeComment_111 asemeComment
highlight default link asemeComment_113 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_118 asemeComment
highlight default link asemeComment_120 asemeComment
highlight default link asemeComment_123 asemeComment
highlight default link asemeComment_127 asemeComment
highlight default link asemeComment_131 asemeComment
highlight default link asemeComment_136 asemeComment
highlight default link asemeComment_138 asemeComment
highlight default link asemeComment_140 asemeComment
highlight default link asemeComment_142 asemeComment
highlight default link asemeComment_145 asemeComment
highlight default link asemeComment_147 asemeComment
highlight default link asemeComment_150 asemeComment
highlight default link asemeComment_153 asemeComment
highlight default link asemeComment_157 asemeComment
highlight default link asemeComment_161 asemeComment
highlight default link asemeComment_164 asemeComment
highlight default link asemeComment_166 asemeComment
highlight default link asemeComment_168 asemeComment
highlight default link asemeComment_170 asemeComment
highlight default link asemeComment_172 asemeComment
highlight default link asemeComment_175 asemeComment
highlight default link asemeComment_180 asemeComment
highlight default link asemeComment_183 asemeComment
highlight default link asemeComment_186 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_191 asemeComment
highlight default link asemeComment_193 asemeComment
highlight default link asemeComment_196 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_200 asemeComment
highlight default link asemeComment_202 asemeComment
highlight default link asemeComment_204 asemeComment
highlight default link asemeComment_207 asemeComment
highlight default link asemeComment_210 asemeComment
highlight default link asemeComment_213 asemeComment
highlight default link asemeComment_218 asemeComment
highlight default link asemeComment_221 asemeComment
highlight default link asemeComment_223 asemeComment
highlight default link asemeComment_225 asemeComment
highlight default link asemeComment_228 asemeComment
highlight default link asemeComment_232 asemeComment
highlight default link asemeComment_234 asemeComment
highlight default link asemeComment_237 asemeComment
highlight default link asemeComment_238 asemeComment
highlight default link asemeComment_241 asemeComment
highlight default link asemeComment_243 asemeComment
highlight default link asemeComment_245 asemeComment
highlight default link asemeComment_248 asemeComment
highlight default link asemeComment_273 asemeComment
highlight default link asemeComment_275 asemeComment
highlight default link asemeComment_281 asemeComment
highlight default link asemeComment_283 asemeComment
highlight default link asemeComment_285 asemeComment
highlight default link asemeComment_288 asemeComment
highlight default link asemeComment_290 asemeComment
highlight default link asemeComment_292 asemeComment
highlight default link asemeComment_294 asemeComment
highlight default link asemeComment_297 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_303 asemeComment
highlight default link asemeComment_306 asemeComment
highlight default link asemeComment_309 asemeComment
highlight default link asemeComment_311 asemeComment
highlight default link asemeComment_313 asemeComment
highlight default link asemeComment_315 asemeComment
highlight default link asemeComment_317 asemeComment
highlight default link asemeComment_320 asemeComment
highlight default link asemeComment_323 asemeComment
highlight default link asemeComment_325 asemeComment
highlight default link asemeComment_327 asemeComment
highlight default link asemeComment_329 asemeComment
highlight default link asemeComment_333 asemeComment
highlight default link asemeComment_336 asemeComment
highlight default link asemeComment_339 asemeComment
highlight default link asemeComment_351 asemeComment
highlight default link asemeComment_354 asemeComment
highlight default link asemeComment_356 asemeComment
highlight default link asemeComment_359 asemeComment
highlight default link asemeComment_36 asemeComment
highlight default link asemeComment_361 asemeComment
highlight default link asemeComment_364 asemeComment
highlight default link asemeComment_367 asemeComment
highlight default link asemeComment_370 asemeComment
highlight default link asemeComment_375 asemeComment
highlight default link asemeComment_378 asemeComment
highlight default link asemeComment_384 asemeComment
highlight default link asemeComment_386 asemeComment
highlight default link asemeComment_388 asemeComment
highlight default link asemeComment_39 asemeComment
highlight default link asemeComment_390 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_394 asemeComment
highlight default link asemeComment_397 asemeComment
highlight default link asemeComment_399 asemeComment
highlight default link asemeComment_401 asemeComment
highlight default link asemeComment_404 asemeComment
highlight default link asemeComment_41 asemeComment
highlight default link asemeComment_43 asemeComment
highlight default link asemeComment_433 asemeComment
highlight default link asemeComment_436 asemeComment
highlight default link asemeComment_438 asemeComment
highlight default link asemeComment_440 asemeComment
highlight default link asemeComment_443 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_466 asemeComment
highlight default link asemeComment_468 asemeComment
highlight default link asemeComment_470 asemeComment
highlight default link asemeComment_473 asemeComment
highlight default link asemeComment_476 asemeComment
highlight default link asemeComment_479 asemeComment
highlight default link asemeComment_481 asemeComment
highlight default link asemeComment_484 asemeComment
highlight default link asemeComment_487 asemeComment
highlight default link asemeComment_489 asemeComment
highlight default link asemeComment_491 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_495 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_501 asemeComment
highlight default link asemeComment_503 asemeComment
highlight default link asemeComment_505 asemeComment
highlight default link asemeComment_507 asemeComment
highlight default link asemeComment_510 asemeComment
highlight default link asemeComment_513 asemeComment
highlight default link asemeComment_516 asemeComment
highlight default link asemeComment_518 asemeComment
highlight default link asemeComment_520 asemeComment
highlight default link asemeComment_523 asemeComment
highlight default link asemeComment_526 asemeComment
highlight default link asemeComment_528 asemeComment
highlight default link asemeComment_531 asemeComment
highlight default link asemeComment_533 asemeComment
highlight default link asemeComment_535 asemeComment
highlight default link asemeComment_537 asemeComment
highlight default link asemeComment_539 asemeComment
highlight default link asemeComment_542 asemeComment
highlight default link asemeComment_546 asemeComment
highlight default link asemeComment_549 asemeComment
highlight default link asemeComment_551 asemeComment
highlight default link asemeComment_553 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_557 asemeComment
highlight default link asemeComment_560 asemeComment
highlight default link asemeComment_562 asemeComment
highlight default link asemeComment_564 asemeComment
highlight default link asemeComment_567 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_594 asemeComment
highlight default link asemeComment_600 asemeComment
highlight default link asemeComment_602 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_609 asemeComment
highlight default link asemeComment_611 asemeComment
highlight default link asemeComment_613 asemeComment
highlight default link asemeComment_617 asemeComment
highlight default link asemeComment_620 asemeComment
highlight default link asemeComment_623 asemeComment
highlight default link asemeComment_633 asemeComment
highlight default link asemeComment_635 asemeComment
highlight default link asemeComment_637 asemeComment
highlight default link asemeComment_640 asemeComment
highlight default link asemeComment_643 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_649 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_655 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_661 asemeComment
highlight default link asemeComment_664 asemeComment
highlight default link asemeComment_669 asemeComment
highlight default link asemeComment_671 asemeComment
highlight default link asemeComment_673 asemeComment
highlight default link asemeComment_677 asemeComment
highlight default link asemeComment_679 asemeComment
highlight default link asemeComment_682 asemeComment
highlight default link asemeComment_687 asemeComment
highlight default link asemeComment_69 asemeComment
highlight default link asemeComment_692 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_696 asemeComment
highlight default link asemeComment_699 asemeComment
highlight default link asemeComment_702 asemeComment
highlight default link asemeComment_705 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_71 asemeComment
highlight default link asemeComment_711 asemeComment
highlight default link asemeComment_714 asemeComment
highlight default link asemeComment_717 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_723 asemeComment
highlight default link asemeComment_727 asemeComment
highlight default link asemeComment_73 asemeComment
highlight default link asemeComment_732 asemeComment
highlight default link asemeComment_735 asemeComment
highlight default link asemeComment_739 asemeComment
highlight default link asemeComment_742 asemeComment
highlight default link asemeComment_745 asemeComment
highlight default link asemeComment_748 asemeComment
highlight default link asemeComment_75 asemeComment
highlight default link asemeComment_750 asemeComment
highlight default link asemeComment_753 asemeComment
highlight default link asemeComment_756 asemeComment
highlight default link asemeComment_758 asemeComment
highlight default link asemeComment_763 asemeComment
highlight default link asemeComment_765 asemeComment
highlight default link asemeComment_768 asemeComment
highlight default link asemeComment_770 asemeComment
highlight default link asemeComment_772 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_780 asemeComment
highlight default link asemeComment_782 asemeComment
highlight default link asemeComment_788 asemeComment
highlight default link asemeComment_790 asemeComment
highlight default link asemeComment_792 asemeComment
highlight default link asemeComment_795 asemeComment
highlight default link asemeComment_797 asemeComment
highlight default link asemeComment_799 asemeComment
highlight default link asemeComment_80 asemeComment
highlight default link asemeComment_800 asemeComment
highlight default link asemeComment_803 asemeComment
highlight default link asemeComment_805 asemeComment
highlight default link asemeComment_807 asemeComment
highlight default link asemeComment_810 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_833 asemeComment
highlight default link asemeComment_835 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_840 asemeComment
highlight default link asemeComment_841 asemeComment
highlight default link asemeComment_844 asemeComment
highlight default link asemeComment_846 asemeComment
highlight default link asemeComment_848 asemeComment
highlight default link asemeComment_85 asemeComment
highlight default link asemeComment_851 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_876 asemeComment
highlight default link asemeComment_878 asemeComment
highlight default link asemeComment_884 asemeComment
highlight default link asemeComment_886 asemeComment
highlight default link asemeComment_888 asemeComment
highlight default link asemeComment_891 asemeComment
highlight default link asemeComment_893 asemeComment
highlight default link asemeComment_895 asemeComment
highlight default link asemeComment_897 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_900 asemeComment
highlight default link asemeComment_903 asemeComment
highlight default link asemeComment_904 asemeComment
highlight default link asemeComment_907 asemeComment
highlight default link asemeComment_909 asemeComment
highlight default link asemeComment_91 asemeComment
highlight default link asemeComment_911 asemeComment
highlight default link asemeComment_914 asemeComment
highlight default link asemeComment_937 asemeComment
highlight default link asemeComment_939 asemeComment
highlight default link asemeComment_941 asemeComment
highlight default link asemeComment_943 asemeComment
highlight default link asemeComment_945 asemeComment
highlight default link asemeComment_947 asemeComment
highlight default link asemeComment_949 asemeComment
highlight default link asemeComment_952 asemeComment
highlight default link asemeComment_955 asemeComment
highlight default link asemeComment_958 asemeComment
highlight default link asemeComment_96 asemeComment
highlight default link asemeComment_962 asemeComment
highlight default link asemeComment_965 asemeComment
highlight default link asemeComment_99 asemeComment
highlight default link asemeComment_991 asemeComment
highlight default link asemeComment_994 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_1004 asemeDeclaration
highlight default link asemeDeclaration_108 asemeDeclaration
highlight default link asemeDeclaration_130 asemeDeclaration
highlight default link asemeDeclaration_135 asemeDeclaration
highlight default link asemeDeclaration_165 asemeDeclaration
highlight default link asemeDeclaration_179 asemeDeclaration
highlight default link asemeDeclaration_185 asemeDeclaration
highlight default link asemeDeclaration_188 asemeDeclaration
highlight default link asemeDeclaration_199 asemeDeclaration
highlight default link asemeDeclaration_217 asemeDeclaration
highlight default link asemeDeclaration_220 asemeDeclaration
highlight default link asemeDeclaration_231 asemeDeclaration
highlight default link asemeDeclaration_284 asemeDeclaration
highlight default link asemeDeclaration_289 asemeDeclaration
highlight default link asemeDeclaration_310 asemeDeclaration
highlight default link asemeDeclaration_324 asemeDeclaration
highlight default link asemeDeclaration_350 asemeDeclaration
highlight default link asemeDeclaration_353 asemeDeclaration
highlight default link asemeDeclaration_381 asemeDeclaration
highlight default link asemeDeclaration_385 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_432 asemeDeclaration
highlight default link asemeDeclaration_480 asemeDeclaration
highlight default link asemeDeclaration_486 asemeDeclaration
highlight default link asemeDeclaration_498 asemeDeclaration
highlight default link asemeDeclaration_534 asemeDeclaration
highlight default link asemeDeclaration_550 asemeDeclaration
highlight default link asemeDeclaration_603 asemeDeclaration
highlight default link asemeDeclaration_608 asemeDeclaration
highlight default link asemeDeclaration_632 asemeDeclaration
highlight default link asemeDeclaration_691 asemeDeclaration
highlight default link asemeDeclaration_70 asemeDeclaration
highlight default link asemeDeclaration_738 asemeDeclaration
highlight default link asemeDeclaration_741 asemeDeclaration
highlight default link asemeDeclaration_747 asemeDeclaration
highlight default link asemeDeclaration_757 asemeDeclaration
highlight default link asemeDeclaration_764 asemeDeclaration
highlight default link asemeDeclaration_767 asemeDeclaration
highlight default link asemeDeclaration_791 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_82 asemeDeclaration
highlight default link asemeDeclaration_834 asemeDeclaration
highlight default link asemeDeclaration_887 asemeDeclaration
highlight default link asemeDeclaration_892 asemeDeclaration
highlight default link asemeDeclaration_894 asemeDeclaration
highlight default link asemeDeclaration_896 asemeDeclaration
highlight default link asemeDeclaration_902 asemeDeclaration
highlight default link asemeDeclaration_964 asemeDeclaration
highlight default link asemeDeclaration_98 asemeDeclaration
highlight default link asemeDeclaration_993 asemeDeclaration
highlight default link asemeLogic_13 asemeLogic
highlight default link asemeLogic_252 asemeLogic
highlight default link asemeLogic_408 asemeLogic
highlight default link asemeLogic_447 asemeLogic
highlight default link asemeLogic_50 asemeLogic
highlight default link asemeLogic_571 asemeLogic
highlight default link asemeLogic_814 asemeLogic
highlight default link asemeLogic_855 asemeLogic
highlight default link asemeLogic_918 asemeLogic
highlight default link asemeName_100 asemeName
highlight default link asemeName_148 asemeName
highlight default link asemeName_155 asemeName
highlight default link asemeName_160 asemeName
highlight default link asemeName_163 asemeName
highlight default link asemeName_177 asemeName
highlight default link asemeName_178 asemeName
highlight default link asemeName_215 asemeName
highlight default link asemeName_216 asemeName
highlight default link asemeName_274 asemeName
highlight default link asemeName_282 asemeName
highlight default link asemeName_287 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_326 asemeName
highlight default link asemeName_334 asemeName
highlight default link asemeName_346 asemeName
highlight default link asemeName_362 asemeName
highlight default link asemeName_373 asemeName
highlight default link asemeName_380 asemeName
highlight default link asemeName_383 asemeName
highlight default link asemeName_545 asemeName
highlight default link asemeName_548 asemeName
highlight default link asemeName_593 asemeName
highlight default link asemeName_601 asemeName
highlight default link asemeName_606 asemeName
highlight default link asemeName_610 asemeName
highlight default link asemeName_618 asemeName
highlight default link asemeName_630 asemeName
highlight default link asemeName_670 asemeName
highlight default link asemeName_678 asemeName
highlight default link asemeName_68 asemeName
highlight default link asemeName_689 asemeName
highlight default link asemeName_736 asemeName
highlight default link asemeName_77 asemeName
highlight default link asemeName_773 asemeName
highlight default link asemeName_777 asemeName
highlight default link asemeName_783 asemeName
highlight default link asemeName_785 asemeName
highlight default link asemeName_877 asemeName
highlight default link asemeName_885 asemeName
highlight default link asemeName_89 asemeName
highlight default link asemeName_890 asemeName
highlight default link asemeName_93 asemeName
highlight default link asemeName_936 asemeName
highlight default link asemeName_94 asemeName
highlight default link asemeName_951 asemeName
highlight default link asemeName_953 asemeName
highlight default link asemeName_959 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1008 asemeNumber
highlight default link asemeNumber_11 asemeNumber
highlight default link asemeNumber_114 asemeNumber
highlight default link asemeNumber_121 asemeNumber
highlight default link asemeNumber_222 asemeNumber
highlight default link asemeNumber_226 asemeNumber
highlight default link asemeNumber_250 asemeNumber
highlight default link asemeNumber_32 asemeNumber
highlight default link asemeNumber_340 asemeNumber
highlight default link asemeNumber_342 asemeNumber
highlight default link asemeNumber_357 asemeNumber
highlight default link asemeNumber_368 asemeNumber
highlight default link asemeNumber_387 asemeNumber
highlight default link asemeNumber_391 asemeNumber
highlight default link asemeNumber_406 asemeNumber
highlight default link asemeNumber_427 asemeNumber
highlight default link asemeNumber_429 asemeNumber
highlight default link asemeNumber_445 asemeNumber
highlight default link asemeNumber_465 asemeNumber
highlight default link asemeNumber_469 asemeNumber
highlight default link asemeNumber_48 asemeNumber
highlight default link asemeNumber_569 asemeNumber
highlight default link asemeNumber_624 asemeNumber
highlight default link asemeNumber_626 asemeNumber
highlight default link asemeNumber_641 asemeNumber
highlight default link asemeNumber_644 asemeNumber
highlight default link asemeNumber_647 asemeNumber
highlight default link asemeNumber_656 asemeNumber
highlight default link asemeNumber_700 asemeNumber
highlight default link asemeNumber_703 asemeNumber
highlight default link asemeNumber_706 asemeNumber
highlight default link asemeNumber_715 asemeNumber
highlight default link asemeNumber_72 asemeNumber
highlight default link asemeNumber_781 asemeNumber
highlight default link asemeNumber_789 asemeNumber
highlight default link asemeNumber_794 asemeNumber
highlight default link asemeNumber_798 asemeNumber
highlight default link asemeNumber_812 asemeNumber
highlight default link asemeNumber_832 asemeNumber
highlight default link asemeNumber_84 asemeNumber
highlight default link asemeNumber_853 asemeNumber
highlight default link asemeNumber_916 asemeNumber
highlight default link asemeNumber_942 asemeNumber
highlight default link asemeNumber_946 asemeNumber
highlight default link asemeNumber_967 asemeNumber
highlight default link asemeNumber_973 asemeNumber
highlight default link asemeNumber_979 asemeNumber
highlight default link asemeNumber_985 asemeNumber
highlight default link asemeNumber_996 asemeNumber
highlight default link asemeOperator_139 asemeOperator
highlight default link asemeOperator_267 asemeOperator
highlight default link asemeOperator_269 asemeOperator
highlight default link asemeOperator_28 asemeOperator
highlight default link asemeOperator_286 asemeOperator
highlight default link asemeOperator_343 asemeOperator
highlight default link asemeOperator_345 asemeOperator
highlight default link asemeOperator_377 asemeOperator
highlight default link asemeOperator_382 asemeOperator
highlight default link asemeOperator_392 asemeOperator
highlight default link asemeOperator_423 asemeOperator
highlight default link asemeOperator_430 asemeOperator
highlight default link asemeOperator_462 asemeOperator
highlight default link asemeOperator_467 asemeOperator
highlight default link asemeOperator_472 asemeOperator
highlight default link asemeOperator_474 asemeOperator
highlight default link asemeOperator_477 asemeOperator
highlight default link asemeOperator_502 asemeOperator
highlight default link asemeOperator_512 asemeOperator
highlight default link asemeOperator_538 asemeOperator
highlight default link asemeOperator_586 asemeOperator
highlight default link asemeOperator_588 asemeOperator
highlight default link asemeOperator_605 asemeOperator
highlight default link asemeOperator_627 asemeOperator
highlight default link asemeOperator_629 asemeOperator
highlight default link asemeOperator_65 asemeOperator
highlight default link asemeOperator_67 asemeOperator
highlight default link asemeOperator_734 asemeOperator
highlight default link asemeOperator_74 asemeOperator
highlight default link asemeOperator_749 asemeOperator
highlight default link asemeOperator_751 asemeOperator
highlight default link asemeOperator_754 asemeOperator
highlight default link asemeOperator_796 asemeOperator
highlight default link asemeOperator_829 asemeOperator
highlight default link asemeOperator_86 asemeOperator
highlight default link asemeOperator_870 asemeOperator
highlight default link asemeOperator_872 asemeOperator
highlight default link asemeOperator_889 asemeOperator
highlight default link asemeOperator_933 asemeOperator
highlight default link asemeOperator_935 asemeOperator
highlight default link asemeOperator_950 asemeOperator
highlight default link asemeOperator_969 asemeOperator
highlight default link asemeOperator_975 asemeOperator
highlight default link asemeOperator_981 asemeOperator
highlight default link asemeOperator_987 asemeOperator
highlight default link asemeOperator_998 asemeOperator
highlight default link asemePunctuation_1000 asemePunctuation
highlight default link asemePunctuation_1011 asemePunctuation
highlight default link asemePunctuation_104 asemePunctuation
highlight default link asemePunctuation_126 asemePunctuation
highlight default link asemePunctuation_132 asemePunctuation
highlight default link asemePunctuation_144 asemePunctuation
highlight default link asemePunctuation_146 asemePunctuation
highlight default link asemePunctuation_152 asemePunctuation
highlight default link asemePunctuation_154 asemePunctuation
highlight default link asemePunctuation_159 asemePunctuation
highlight default link asemePunctuation_162 asemePunctuation
highlight default link asemePunctuation_174 asemePunctuation
highlight default link asemePunctuation_181 asemePunctuation
highlight default link asemePunctuation_187 asemePunctuation
highlight default link asemePunctuation_192 asemePunctuation
highlight default link asemePunctuation_195 asemePunctuation
highlight default link asemePunctuation_212 asemePunctuation
highlight default link asemePunctuation_219 asemePunctuation
highlight default link asemePunctuation_224 asemePunctuation
highlight default link asemePunctuation_227 asemePunctuation
highlight default link asemePunctuation_229 asemePunctuation
highlight default link asemePunctuation_236 asemePunctuation
highlight default link asemePunctuation_239 asemePunctuation
highlight default link asemePunctuation_268 asemePunctuation
highlight default link asemePunctuation_272 asemePunctuation
highlight default link asemePunctuation_280 asemePunctuation
highlight default link asemePunctuation_29 asemePunctuation
highlight default link asemePunctuation_302 asemePunctuation
highlight default link asemePunctuation_316 asemePunctuation
highlight default link asemePunctuation_328 asemePunctuation
highlight default link asemePunctuation_332 asemePunctuation
highlight default link asemePunctuation_335 asemePunctuation
highlight default link asemePunctuation_337 asemePunctuation
highlight default link asemePunctuation_344 asemePunctuation
highlight default link asemePunctuation_347 asemePunctuation
highlight default link asemePunctuation_35 asemePunctuation
highlight default link asemePunctuation_37 asemePunctuation
highlight default link asemePunctuation_374 asemePunctuation
highlight default link asemePunctuation_379 asemePunctuation
highlight default link asemePunctuation_395 asemePunctuation
highlight default link asemePunctuation_424 asemePunctuation
highlight default link asemePunctuation_425 asemePunctuation
highlight default link asemePunctuation_431 asemePunctuation
highlight default link asemePunctuation_434 asemePunctuation
highlight default link asemePunctuation_463 asemePunctuation
highlight default link asemePunctuation_464 asemePunctuation
highlight default link asemePunctuation_471 asemePunctuation
highlight default link asemePunctuation_482 asemePunctuation
highlight default link asemePunctuation_494 asemePunctuation
highlight default link asemePunctuation_515 asemePunctuation
highlight default link asemePunctuation_519 asemePunctuation
highlight default link asemePunctuation_522 asemePunctuation
highlight default link asemePunctuation_525 asemePunctuation
highlight default link asemePunctuation_530 asemePunctuation
highlight default link asemePunctuation_541 asemePunctuation
highlight default link asemePunctuation_555 asemePunctuation
highlight default link asemePunctuation_558 asemePunctuation
highlight default link asemePunctuation_587 asemePunctuation
highlight default link asemePunctuation_591 asemePunctuation
highlight default link asemePunctuation_599 asemePunctuation
highlight default link asemePunctuation_612 asemePunctuation
highlight default link asemePunctuation_616 asemePunctuation
highlight default link asemePunctuation_619 asemePunctuation
highlight default link asemePunctuation_621 asemePunctuation
highlight default link asemePunctuation_628 asemePunctuation
highlight default link asemePunctuation_631 asemePunctuation
highlight default link asemePunctuation_66 asemePunctuation
highlight default link asemePunctuation_668 asemePunctuation
highlight default link asemePunctuation_672 asemePunctuation
highlight default link asemePunctuation_676 asemePunctuation
highlight default link asemePunctuation_686 asemePunctuation
highlight default link asemePunctuation_688 asemePunctuation
highlight default link asemePunctuation_690 asemePunctuation
highlight default link asemePunctuation_731 asemePunctuation
highlight default link asemePunctuation_737 asemePunctuation
highlight default link asemePunctuation_743 asemePunctuation
highlight default link asemePunctuation_759 asemePunctuation
highlight default link asemePunctuation_76 asemePunctuation
highlight default link asemePunctuation_78 asemePunctuation
highlight default link asemePunctuation_793 asemePunctuation
highlight default link asemePunctuation_801 asemePunctuation
highlight default link asemePunctuation_830 asemePunctuation
highlight default link asemePunctuation_831 asemePunctuation
highlight default link asemePunctuation_839 asemePunctuation
highlight default link asemePunctuation_842 asemePunctuation
highlight default link asemePunctuation_871 asemePunctuation
highlight default link asemePunctuation_875 asemePunctuation
highlight default link asemePunctuation_88 asemePunctuation
highlight default link asemePunctuation_883 asemePunctuation
highlight default link asemePunctuation_898 asemePunctuation
highlight default link asemePunctuation_905 asemePunctuation
highlight default link asemePunctuation_934 asemePunctuation
highlight default link asemePunctuation_940 asemePunctuation
highlight default link asemePunctuation_944 asemePunctuation
highlight default link asemePunctuation_948 asemePunctuation
highlight default link asemePunctuation_954 asemePunctuation
highlight default link asemePunctuation_957 asemePunctuation
highlight default link asemePunctuation_960 asemePunctuation
highlight default link asemePunctuation_970 asemePunctuation
highlight default link asemePunctuation_971 asemePunctuation
highlight default link asemePunctuation_976 asemePunctuation
highlight default link asemePunctuation_977 asemePunctuation
highlight default link asemePunctuation_982 asemePunctuation
highlight default link asemePunctuation_983 asemePunctuation
highlight default link asemePunctuation_988 asemePunctuation
highlight default link asemePunctuation_989 asemePunctuation
highlight default link asemePunctuation_999 asemePunctuation
highlight default link asemeReference_1009 asemeReference
highlight default link asemeReference_1010 asemeReference
highlight default link asemeReference_110 asemeReference
highlight default link asemeReference_117 asemeReference
highlight default link asemeReference_125 asemeReference
highlight default link asemeReference_128 asemeReference
highlight default link asemeReference_129 asemeReference
highlight default link asemeReference_167 asemeReference
highlight default link asemeReference_173 asemeReference
highlight default link asemeReference_190 asemeReference
highlight default link asemeReference_197 asemeReference
highlight default link asemeReference_198 asemeReference
highlight default link asemeReference_201 asemeReference
highlight default link asemeReference_205 asemeReference
highlight default link asemeReference_208 asemeReference
highlight default link asemeReference_211 asemeReference
highlight default link asemeReference_240 asemeReference
highlight default link asemeReference_242 asemeReference
highlight default link asemeReference_246 asemeReference
highlight default link asemeReference_266 asemeReference
highlight default link asemeReference_27 asemeReference
highlight default link asemeReference_291 asemeReference
highlight default link asemeReference_295 asemeReference
highlight default link asemeReference_299 asemeReference
highlight default link asemeReference_300 asemeReference
highlight default link asemeReference_304 asemeReference
highlight default link asemeReference_305 asemeReference
highlight default link asemeReference_307 asemeReference
highlight default link asemeReference_308 asemeReference
highlight default link asemeReference_312 asemeReference
highlight default link asemeReference_314 asemeReference
highlight default link asemeReference_318 asemeReference
highlight default link asemeReference_319 asemeReference
highlight default link asemeReference_321 asemeReference
highlight default link asemeReference_322 asemeReference
highlight default link asemeReference_33 asemeReference
highlight default link asemeReference_34 asemeReference
highlight default link asemeReference_341 asemeReference
highlight default link asemeReference_376 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_396 asemeReference
highlight default link asemeReference_398 asemeReference
highlight default link asemeReference_40 asemeReference
highlight default link asemeReference_402 asemeReference
highlight default link asemeReference_422 asemeReference
highlight default link asemeReference_428 asemeReference
highlight default link asemeReference_435 asemeReference
highlight default link asemeReference_437 asemeReference
highlight default link asemeReference_44 asemeReference
highlight default link asemeReference_441 asemeReference
highlight default link asemeReference_461 asemeReference
highlight default link asemeReference_492 asemeReference
highlight default link asemeReference_496 asemeReference
highlight default link asemeReference_497 asemeReference
highlight default link asemeReference_500 asemeReference
highlight default link asemeReference_504 asemeReference
highlight default link asemeReference_508 asemeReference
highlight default link asemeReference_511 asemeReference
highlight default link asemeReference_514 asemeReference
highlight default link asemeReference_517 asemeReference
highlight default link asemeReference_521 asemeReference
highlight default link asemeReference_524 asemeReference
highlight default link asemeReference_527 asemeReference
highlight default link asemeReference_529 asemeReference
highlight default link asemeReference_532 asemeReference
highlight default link asemeReference_536 asemeReference
highlight default link asemeReference_540 asemeReference
highlight default link asemeReference_559 asemeReference
highlight default link asemeReference_561 asemeReference
highlight default link asemeReference_565 asemeReference
highlight default link asemeReference_585 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_625 asemeReference
highlight default link asemeReference_634 asemeReference
highlight default link asemeReference_638 asemeReference
highlight default link asemeReference_64 asemeReference
highlight default link asemeReference_653 asemeReference
highlight default link asemeReference_659 asemeReference
highlight default link asemeReference_662 asemeReference
highlight default link asemeReference_680 asemeReference
highlight default link asemeReference_683 asemeReference
highlight default link asemeReference_684 asemeReference
highlight default link asemeReference_685 asemeReference
highlight default link asemeReference_693 asemeReference
highlight default link asemeReference_697 asemeReference
highlight default link asemeReference_712 asemeReference
highlight default link asemeReference_718 asemeReference
highlight default link asemeReference_721 asemeReference
highlight default link asemeReference_725 asemeReference
highlight default link asemeReference_728 asemeReference
highlight default link asemeReference_729 asemeReference
highlight default link asemeReference_730 asemeReference
highlight default link asemeReference_769 asemeReference
highlight default link asemeReference_802 asemeReference
highlight default link asemeReference_804 asemeReference
highlight default link asemeReference_808 asemeReference
highlight default link asemeReference_828 asemeReference
highlight default link asemeReference_843 asemeReference
highlight default link asemeReference_845 asemeReference
highlight default link asemeReference_849 asemeReference
highlight default link asemeReference_869 asemeReference
highlight default link asemeReference_906 asemeReference
highlight default link asemeReference_908 asemeReference
highlight default link asemeReference_912 asemeReference
highlight default link asemeReference_932 asemeReference
highlight default link asemeReference_956 asemeReference
highlight default link asemeReference_968 asemeReference
highlight default link asemeReference_974 asemeReference
highlight default link asemeReference_980 asemeReference
highlight default link asemeReference_986 asemeReference
highlight default link asemeReference_997 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1001 asemeText
highlight default link asemeText_1003 asemeText
highlight default link asemeText_1006 asemeText
highlight default link asemeText_1007 asemeText
highlight default link asemeText_137 asemeText
highlight default link asemeText_176 asemeText
highlight default link asemeText_214 asemeText
highlight default link asemeText_230 asemeText
highlight default link asemeText_249 asemeText
highlight default link asemeText_30 asemeText
highlight default link asemeText_31 asemeText
highlight default link asemeText_338 asemeText
highlight default link asemeText_352 asemeText
highlight default link asemeText_405 asemeText
highlight default link asemeText_426 asemeText
highlight default link asemeText_444 asemeText
highlight default link asemeText_47 asemeText
highlight default link asemeText_543 asemeText
highlight default link asemeText_544 asemeText
highlight default link asemeText_547 asemeText
highlight default link asemeText_568 asemeText
highlight default link asemeText_622 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_733 asemeText
highlight default link asemeText_740 asemeText
highlight default link asemeText_774 asemeText
highlight default link asemeText_778 asemeText
highlight default link asemeText_784 asemeText
highlight default link asemeText_786 asemeText
highlight default link asemeText_811 asemeText
highlight default link asemeText_852 asemeText
highlight default link asemeText_915 asemeText
highlight default link asemeText_966 asemeText
highlight default link asemeText_972 asemeText
highlight default link asemeText_978 asemeText
highlight default link asemeText_984 asemeText
highlight default link asemeText_990 asemeText
highlight default link asemeText_992 asemeText
highlight default link asemeText_995 asemeText
highlight default link asemeTruth_12 asemeTruth
highlight default link asemeTruth_251 asemeTruth
highlight default link asemeTruth_407 asemeTruth
highlight default link asemeTruth_446 asemeTruth
highlight default link asemeTruth_49 asemeTruth
highlight default link asemeTruth_570 asemeTruth
highlight default link asemeTruth_813 asemeTruth
highlight default link asemeTruth_854 asemeTruth
highlight default link asemeTruth_917 asemeTruth
highlight default link asemeType_103 asemeType
highlight default link asemeType_143 asemeType
highlight default link asemeType_151 asemeType
highlight default link asemeType_158 asemeType
highlight default link asemeType_235 asemeType
highlight default link asemeType_271 asemeType
highlight default link asemeType_277 asemeType
highlight default link asemeType_279 asemeType
highlight default link asemeType_331 asemeType
highlight default link asemeType_554 asemeType
highlight default link asemeType_590 asemeType
highlight default link asemeType_596 asemeType
highlight default link asemeType_598 asemeType
highlight default link asemeType_615 asemeType
highlight default link asemeType_667 asemeType
highlight default link asemeType_675 asemeType
highlight default link asemeType_838 asemeType
highlight default link asemeType_874 asemeType
highlight default link asemeType_880 asemeType
highlight default link asemeType_882 asemeType
highlight default link asemeType_92 asemeType
highlight default link asemeType_97 asemeType
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
