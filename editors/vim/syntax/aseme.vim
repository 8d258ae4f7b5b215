" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1346 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1345 /\v\w+/
syntax match asemeNumber_1344 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1343 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1342 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1347 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1342,asemeText_1343,asemeNumber_1344,asemeReference_1345,asemeReference_1346,asemePunctuation_1347,asemeComment
syntax match asemeReference_38 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_37 /\v\w+/ contained
syntax match asemeNumber_36 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_35 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_34 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_39 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_12,asemeDeclaration_75,asemeDeclaration_87,asemeDeclaration_113,asemeDeclaration_147,asemeDeclaration_188,asemeDeclaration_214,asemeDeclaration_247,asemeDeclaration_707,asemeDeclaration_1082,asemeDeclaration_1085,asemeDeclaration_1230,asemeDeclaration_1300,asemeDeclaration_1329,asemeDeclaration_1340,asemeText_1342,asemeText_1343,asemeNumber_1344,asemeReference_1345,asemeReference_1346,asemePunctuation_1347,asemeComment
syntax match asemeDeclaration_1340 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1339,asemeComment_1341 skipwhite skipempty
syntax region asemeComment_1341 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1339,asemeComment_1341 skipwhite skipempty
syntax match asemeComment_1341 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1339,asemeComment_1341 skipwhite skipempty
syntax match asemeText_1339 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1338 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1336,asemeText_1337
syntax match asemeText_1337 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1338 skipwhite skipempty
syntax region asemeComment_1338 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1338 skipwhite skipempty
syntax match asemeComment_1338 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1338 skipwhite skipempty
syntax region asemePunctuation_1336 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_1319,asemeText_1331,asemeNumber_1332,asemeReference_1333,asemeOperator_1334,asemePunctuation_1335,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemePunctuation_1335 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1334 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1333 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1332 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1331 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1329 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_1328,asemeComment_1330 skipwhite skipempty
syntax region asemeComment_1330 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1328,asemeComment_1330 skipwhite skipempty
syntax match asemeComment_1330 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1328,asemeComment_1330 skipwhite skipempty
syntax match asemeText_1328 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1327 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_1325,asemeText_1326
syntax match asemeText_1326 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1327 skipwhite skipempty
syntax region asemeComment_1327 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1327 skipwhite skipempty
syntax match asemeComment_1327 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1327 skipwhite skipempty
syntax region asemePunctuation_1325 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_1319,asemeText_1320,asemeNumber_1321,asemeReference_1322,asemeOperator_1323,asemePunctuation_1324,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemePunctuation_1324 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1323 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1322 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1321 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1320 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1319 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_1313,asemeText_1314,asemeNumber_1315,asemeReference_1316,asemeOperator_1317,asemePunctuation_1318,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemePunctuation_1318 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1317 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1316 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1315 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1314 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1313 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_1307,asemeText_1308,asemeNumber_1309,asemeReference_1310,asemeOperator_1311,asemePunctuation_1312,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemePunctuation_1312 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1311 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1310 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1309 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1308 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1307 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_1302,asemeNumber_1303,asemeReference_1304,asemeOperator_1305,asemePunctuation_1306,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemePunctuation_1306 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1305 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1304 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1303 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1302 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1300 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_1299,asemeComment_1301 skipwhite skipempty
syntax region asemeComment_1301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1299,asemeComment_1301 skipwhite skipempty
syntax match asemeComment_1301 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1299,asemeComment_1301 skipwhite skipempty
syntax match asemeBlock_1299 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1298 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_1296,asemeBlock_1297
syntax match asemeBlock_1297 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1298 skipwhite skipempty
syntax region asemeComment_1298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1298 skipwhite skipempty
syntax match asemeComment_1298 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1298 skipwhite skipempty
syntax region asemePunctuation_1296 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_1295,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeName_1295 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_1267,asemePunctuation_1277,asemePunctuation_1282,asemePunctuation_1288,asemePunctuation_1291,asemePunctuation_1293,asemeOperator_1294
syntax match asemeOperator_1294 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemePunctuation_1293 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax match asemePunctuation_1291 /\v\:/ contained nextgroup=asemeReference_1290,asemeComment_1292 skipwhite skipempty
syntax region asemeComment_1292 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1290,asemeComment_1292 skipwhite skipempty
syntax match asemeComment_1292 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1290,asemeComment_1292 skipwhite skipempty
syntax match asemeReference_1290 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax match asemePunctuation_1288 /\v\,/ contained nextgroup=asemeName_1285,asemeName_1287,asemeComment_1289 skipwhite skipempty
syntax region asemeComment_1289 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1285,asemeName_1287,asemeComment_1289 skipwhite skipempty
syntax match asemeComment_1289 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1285,asemeName_1287,asemeComment_1289 skipwhite skipempty
syntax match asemeName_1287 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax match asemeName_1285 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1284,asemeComment_1286 skipwhite skipempty
syntax region asemeComment_1286 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1284,asemeComment_1286 skipwhite skipempty
syntax match asemeComment_1286 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1284,asemeComment_1286 skipwhite skipempty
syntax match asemeOperator_1284 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemePunctuation_1282 /\v\.\./ contained nextgroup=asemeNumber_1280,asemeComment_1283 skipwhite skipempty
syntax region asemeComment_1283 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1280,asemeComment_1283 skipwhite skipempty
syntax match asemeComment_1283 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1280,asemeComment_1283 skipwhite skipempty
syntax match asemeNumber_1280 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1279,asemeComment_1281 skipwhite skipempty
syntax region asemeComment_1281 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1279,asemeComment_1281 skipwhite skipempty
syntax match asemeComment_1281 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1279,asemeComment_1281 skipwhite skipempty
syntax match asemePunctuation_1279 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax match asemePunctuation_1277 /\v\[/ contained nextgroup=asemeNumber_1275,asemeComment_1278 skipwhite skipempty
syntax region asemeComment_1278 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1275,asemeComment_1278 skipwhite skipempty
syntax match asemeComment_1278 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1275,asemeComment_1278 skipwhite skipempty
syntax match asemeNumber_1275 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1273,asemeComment_1276 skipwhite skipempty
syntax region asemeComment_1276 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1273,asemeComment_1276 skipwhite skipempty
syntax match asemeComment_1276 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1273,asemeComment_1276 skipwhite skipempty
syntax match asemePunctuation_1273 /\v\.\./ contained nextgroup=asemeNumber_1271,asemeComment_1274 skipwhite skipempty
syntax region asemeComment_1274 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1271,asemeComment_1274 skipwhite skipempty
syntax match asemeComment_1274 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1271,asemeComment_1274 skipwhite skipempty
syntax match asemeNumber_1271 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1269,asemeComment_1272 skipwhite skipempty
syntax region asemeComment_1272 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1269,asemeComment_1272 skipwhite skipempty
syntax match asemeComment_1272 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1269,asemeComment_1272 skipwhite skipempty
syntax match asemePunctuation_1269 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax region asemeComment_1270 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax match asemeComment_1270 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1270 skipwhite skipempty
syntax match asemeClause_1267 /\vwith%(<|>)/ contained nextgroup=asemeName_1265,asemeComment_1268 skipwhite skipempty
syntax region asemeComment_1268 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1265,asemeComment_1268 skipwhite skipempty
syntax match asemeComment_1268 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1265,asemeComment_1268 skipwhite skipempty
syntax match asemeName_1265 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1264,asemeComment_1266 skipwhite skipempty
syntax region asemeComment_1266 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1264,asemeComment_1266 skipwhite skipempty
syntax match asemeComment_1266 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1264,asemeComment_1266 skipwhite skipempty
syntax match asemeOperator_1264 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeDeclaration_1230 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_1229,asemeComment_1231 skipwhite skipempty
syntax region asemeComment_1231 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1229,asemeComment_1231 skipwhite skipempty
syntax match asemeComment_1231 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1229,asemeComment_1231 skipwhite skipempty
syntax match asemeBlock_1229 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1228 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_1226,asemeBlock_1227
syntax match asemeBlock_1227 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1228 skipwhite skipempty
syntax region asemeComment_1228 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1228 skipwhite skipempty
syntax match asemeComment_1228 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1228 skipwhite skipempty
syntax region asemePunctuation_1226 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_1109,asemeNumber_1116,asemeDeclaration_1153,asemeDeclaration_1215,asemeDeclaration_1220,asemeDeclaration_1222,asemeDeclaration_1224,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_1224 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1225 skipwhite skipempty
syntax region asemeComment_1225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1225 skipwhite skipempty
syntax match asemeComment_1225 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1225 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_1046
syntax match asemeDeclaration_1222 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1223 skipwhite skipempty
syntax region asemeComment_1223 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1223 skipwhite skipempty
syntax match asemeComment_1223 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1223 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_993
syntax match asemeDeclaration_1220 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_1218,asemeComment_1221 skipwhite skipempty
syntax region asemeComment_1221 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1218,asemeComment_1221 skipwhite skipempty
syntax match asemeComment_1221 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1218,asemeComment_1221 skipwhite skipempty
syntax match asemeName_1218 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1217,asemeComment_1219 skipwhite skipempty
syntax region asemeComment_1219 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1217,asemeComment_1219 skipwhite skipempty
syntax match asemeComment_1219 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1217,asemeComment_1219 skipwhite skipempty
syntax match asemeOperator_1217 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeDeclaration_1215 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_1214,asemeComment_1216 skipwhite skipempty
syntax region asemeComment_1216 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1214,asemeComment_1216 skipwhite skipempty
syntax match asemeComment_1216 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1214,asemeComment_1216 skipwhite skipempty
syntax match asemeName_1214 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemeClause_1158,asemeClause_1160,asemePunctuation_1164,asemeNumber_1169,asemePunctuation_1174,asemePunctuation_1177,asemePunctuation_1179,asemeOperator_1212,asemeName_1213
syntax match asemeName_1213 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeOperator_1212 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemePunctuation_1179 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemePunctuation_1177 /\v\.\./ contained nextgroup=asemeNumber_1176,asemeComment_1178 skipwhite skipempty
syntax region asemeComment_1178 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1176,asemeComment_1178 skipwhite skipempty
syntax match asemeComment_1178 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1176,asemeComment_1178 skipwhite skipempty
syntax match asemeNumber_1176 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemePunctuation_1174 /\v\:/ contained nextgroup=asemeClause_1171,asemeBuiltIn_1172,asemeType_1173,asemeComment_1175 skipwhite skipempty
syntax region asemeComment_1175 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1171,asemeBuiltIn_1172,asemeType_1173,asemeComment_1175 skipwhite skipempty
syntax match asemeComment_1175 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1171,asemeBuiltIn_1172,asemeType_1173,asemeComment_1175 skipwhite skipempty
syntax match asemeType_1173 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeBuiltIn_1172 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeClause_1171 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeNumber_1169 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1167,asemeComment_1170 skipwhite skipempty
syntax region asemeComment_1170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1167,asemeComment_1170 skipwhite skipempty
syntax match asemeComment_1170 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1167,asemeComment_1170 skipwhite skipempty
syntax match asemePunctuation_1167 /\v\.\./ contained nextgroup=asemeNumber_1166,asemeComment_1168 skipwhite skipempty
syntax region asemeComment_1168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1166,asemeComment_1168 skipwhite skipempty
syntax match asemeComment_1168 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1166,asemeComment_1168 skipwhite skipempty
syntax match asemeNumber_1166 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemePunctuation_1164 /\v\[/ contained nextgroup=asemeNumber_1162,asemeComment_1165 skipwhite skipempty
syntax region asemeComment_1165 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1162,asemeComment_1165 skipwhite skipempty
syntax match asemeComment_1165 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1162,asemeComment_1165 skipwhite skipempty
syntax match asemeNumber_1162 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1161,asemeComment_1163 skipwhite skipempty
syntax region asemeComment_1163 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1161,asemeComment_1163 skipwhite skipempty
syntax match asemeComment_1163 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1161,asemeComment_1163 skipwhite skipempty
syntax match asemePunctuation_1161 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeClause_1160 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeClause_1158 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_1155,asemeType_1157,asemeComment_1159 skipwhite skipempty
syntax region asemeComment_1159 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1155,asemeType_1157,asemeComment_1159 skipwhite skipempty
syntax match asemeComment_1159 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1155,asemeType_1157,asemeComment_1159 skipwhite skipempty
syntax match asemeType_1157 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeBuiltIn_1155 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax region asemeComment_1156 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeComment_1156 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1156 skipwhite skipempty
syntax match asemeDeclaration_1153 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_1151,asemeComment_1154 skipwhite skipempty
syntax region asemeComment_1154 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1151,asemeComment_1154 skipwhite skipempty
syntax match asemeComment_1154 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1151,asemeComment_1154 skipwhite skipempty
syntax match asemeNumber_1151 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1150,asemeComment_1152 skipwhite skipempty
syntax region asemeComment_1152 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1150,asemeComment_1152 skipwhite skipempty
syntax match asemeComment_1152 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1150,asemeComment_1152 skipwhite skipempty
syntax match asemePunctuation_1150 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeNumber_1116 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_1114,asemeComment_1117 skipwhite skipempty
syntax region asemeComment_1117 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1114,asemeComment_1117 skipwhite skipempty
syntax match asemeComment_1117 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1114,asemeComment_1117 skipwhite skipempty
syntax match asemeOperator_1114 /\v\-\>/ contained nextgroup=asemeNumber_1112,asemeComment_1115 skipwhite skipempty
syntax region asemeComment_1115 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1112,asemeComment_1115 skipwhite skipempty
syntax match asemeComment_1115 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1112,asemeComment_1115 skipwhite skipempty
syntax match asemeNumber_1112 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1111,asemeComment_1113 skipwhite skipempty
syntax region asemeComment_1113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1111,asemeComment_1113 skipwhite skipempty
syntax match asemeComment_1113 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1111,asemeComment_1113 skipwhite skipempty
syntax match asemePunctuation_1111 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeDeclaration_1109 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_1107,asemeComment_1110 skipwhite skipempty
syntax region asemeComment_1110 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1107,asemeComment_1110 skipwhite skipempty
syntax match asemeComment_1110 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1107,asemeComment_1110 skipwhite skipempty
syntax match asemeNumber_1107 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1105,asemeComment_1108 skipwhite skipempty
syntax region asemeComment_1108 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1105,asemeComment_1108 skipwhite skipempty
syntax match asemeComment_1108 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1105,asemeComment_1108 skipwhite skipempty
syntax match asemeChoice_1105 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1103,asemeText_1104,@asemeChartNodeInBodyOfStatechart,asemeComment_1106 skipwhite skipempty
syntax region asemeComment_1106 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1103,asemeText_1104,@asemeChartNodeInBodyOfStatechart,asemeComment_1106 skipwhite skipempty
syntax match asemeComment_1106 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1103,asemeText_1104,@asemeChartNodeInBodyOfStatechart,asemeComment_1106 skipwhite skipempty
syntax match asemeText_1104 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeName_1103 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_1089,asemeChoice_1093,asemeNumber_1099,asemeName_1101,asemeText_1102
syntax match asemeText_1102 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeName_1101 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeNumber_1099 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1097,asemeComment_1100 skipwhite skipempty
syntax region asemeComment_1100 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1097,asemeComment_1100 skipwhite skipempty
syntax match asemeComment_1100 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1097,asemeComment_1100 skipwhite skipempty
syntax match asemeChoice_1097 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1095,asemeText_1096,@asemeChartNodeInBodyOfStatechart,asemeComment_1098 skipwhite skipempty
syntax region asemeComment_1098 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1095,asemeText_1096,@asemeChartNodeInBodyOfStatechart,asemeComment_1098 skipwhite skipempty
syntax match asemeComment_1098 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1095,asemeText_1096,@asemeChartNodeInBodyOfStatechart,asemeComment_1098 skipwhite skipempty
syntax match asemeText_1096 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeName_1095 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeChoice_1093 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1091,asemeText_1092,@asemeChartNodeInBodyOfStatechart,asemeComment_1094 skipwhite skipempty
syntax region asemeComment_1094 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1091,asemeText_1092,@asemeChartNodeInBodyOfStatechart,asemeComment_1094 skipwhite skipempty
syntax match asemeComment_1094 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1091,asemeText_1092,@asemeChartNodeInBodyOfStatechart,asemeComment_1094 skipwhite skipempty
syntax match asemeText_1092 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeName_1091 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeClause_1089 /\vactivity%(<|>)/ contained nextgroup=asemeReference_1087,asemeComment_1090 skipwhite skipempty
syntax region asemeComment_1090 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1087,asemeComment_1090 skipwhite skipempty
syntax match asemeComment_1090 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1087,asemeComment_1090 skipwhite skipempty
syntax match asemeReference_1087 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax region asemeComment_1088 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeComment_1088 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1088 skipwhite skipempty
syntax match asemeDeclaration_1085 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_1084,asemeComment_1086 skipwhite skipempty
syntax region asemeComment_1086 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1084,asemeComment_1086 skipwhite skipempty
syntax match asemeComment_1086 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1084,asemeComment_1086 skipwhite skipempty
syntax match asemeBlock_1084 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_710 skipwhite skipempty
syntax match asemeDeclaration_1082 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_1080,asemeComment_1083 skipwhite skipempty
syntax region asemeComment_1083 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1080,asemeComment_1083 skipwhite skipempty
syntax match asemeComment_1083 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1080,asemeComment_1083 skipwhite skipempty
syntax match asemeClause_1080 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_1079,asemeComment_1081 skipwhite skipempty
syntax region asemeComment_1081 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1079,asemeComment_1081 skipwhite skipempty
syntax match asemeComment_1081 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1079,asemeComment_1081 skipwhite skipempty
syntax match asemeBlock_1079 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_710 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_711,asemePunctuation_1077,asemeBlock_1078
syntax match asemeBlock_1078 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_710 skipwhite skipempty
syntax region asemePunctuation_1077 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_719,asemeDeclaration_818,asemeDeclaration_834,asemeDeclaration_896,asemeDeclaration_901,asemeDeclaration_925,asemeDeclaration_994,asemeDeclaration_1047,asemeDeclaration_1056,asemeDeclaration_1075,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_1075 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_1073,asemeComment_1076 skipwhite skipempty
syntax region asemeComment_1076 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1073,asemeComment_1076 skipwhite skipempty
syntax match asemeComment_1076 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1073,asemeComment_1076 skipwhite skipempty
syntax match asemeBlock_1073 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1070,asemeOperator_1072,@asemeControlInBodyOfSrm,asemeComment_1074 skipwhite skipempty
syntax region asemeComment_1074 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1070,asemeOperator_1072,@asemeControlInBodyOfSrm,asemeComment_1074 skipwhite skipempty
syntax match asemeComment_1074 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1070,asemeOperator_1072,@asemeControlInBodyOfSrm,asemeComment_1074 skipwhite skipempty
syntax match asemeOperator_1072 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeOperator_1070 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1069,@asemeControlInBodyOfSrm,asemeComment_1071 skipwhite skipempty
syntax region asemeComment_1071 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1069,@asemeControlInBodyOfSrm,asemeComment_1071 skipwhite skipempty
syntax match asemeComment_1071 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1069,@asemeControlInBodyOfSrm,asemeComment_1071 skipwhite skipempty
syntax match asemeOperator_1069 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemeOperator_1060,asemePunctuation_687,asemeOperator_1062,asemeBlock_1067
syntax match asemeBlock_1067 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1064,asemeOperator_1066,@asemeControlInBodyOfSrm,asemeComment_1068 skipwhite skipempty
syntax region asemeComment_1068 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1064,asemeOperator_1066,@asemeControlInBodyOfSrm,asemeComment_1068 skipwhite skipempty
syntax match asemeComment_1068 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1064,asemeOperator_1066,@asemeControlInBodyOfSrm,asemeComment_1068 skipwhite skipempty
syntax match asemeOperator_1066 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeOperator_1064 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1063,@asemeControlInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax region asemeComment_1065 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1063,@asemeControlInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax match asemeComment_1065 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1063,@asemeControlInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax match asemeOperator_1063 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeOperator_1062 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeOperator_1060 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1058,@asemeControlInBodyOfSrm,asemeComment_1061 skipwhite skipempty
syntax region asemeComment_1061 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1058,@asemeControlInBodyOfSrm,asemeComment_1061 skipwhite skipempty
syntax match asemeComment_1061 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1058,@asemeControlInBodyOfSrm,asemeComment_1061 skipwhite skipempty
syntax match asemeOperator_1058 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax region asemeComment_1059 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeComment_1059 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeDeclaration_1056 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_1055,asemeComment_1057 skipwhite skipempty
syntax region asemeComment_1057 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1055,asemeComment_1057 skipwhite skipempty
syntax match asemeComment_1057 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1055,asemeComment_1057 skipwhite skipempty
syntax match asemeBlock_1055 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_1052,asemeBlock_1053
syntax match asemeBlock_1053 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax region asemeComment_1054 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax match asemeComment_1054 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax region asemePunctuation_1052 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_1050,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_1050 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_1049,asemeComment_1051 skipwhite skipempty
syntax region asemeComment_1051 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1049,asemeComment_1051 skipwhite skipempty
syntax match asemeComment_1051 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1049,asemeComment_1051 skipwhite skipempty
syntax match asemeText_1049 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1047 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax region asemeComment_1048 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeComment_1048 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_1046
syntax region asemePunctuation_1046 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_1045,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeName_1045 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_1001,asemeClause_1004,asemeClause_1007,asemeClause_1010,asemeClause_1013,asemeClause_1016,asemeChoice_1019,asemeClause_1022,asemeClause_1025,asemeClause_1028,asemeClause_1030,asemeChoice_1031,asemeChoice_1032,asemePunctuation_1039,asemeOperator_1042,asemeReference_1044
syntax match asemeReference_1044 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeOperator_1042 /\v\=%(\=)@!/ contained nextgroup=asemeText_1041,asemeComment_1043 skipwhite skipempty
syntax region asemeComment_1043 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1041,asemeComment_1043 skipwhite skipempty
syntax match asemeComment_1043 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1041,asemeComment_1043 skipwhite skipempty
syntax match asemeText_1041 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemePunctuation_1039 /\v\,/ contained nextgroup=asemeChoice_1034,asemeReference_1036,asemeReference_1037,asemeReference_1038,asemeComment_1040 skipwhite skipempty
syntax region asemeComment_1040 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1034,asemeReference_1036,asemeReference_1037,asemeReference_1038,asemeComment_1040 skipwhite skipempty
syntax match asemeComment_1040 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1034,asemeReference_1036,asemeReference_1037,asemeReference_1038,asemeComment_1040 skipwhite skipempty
syntax match asemeReference_1038 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeReference_1037 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeReference_1036 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeChoice_1034 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1033,asemeComment_1035 skipwhite skipempty
syntax region asemeComment_1035 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1033,asemeComment_1035 skipwhite skipempty
syntax match asemeComment_1035 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1033,asemeComment_1035 skipwhite skipempty
syntax match asemeReference_1033 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeChoice_1032 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeChoice_1031 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1030 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1028 /\vends%(<|>)/ contained nextgroup=asemeReference_1027,asemeComment_1029 skipwhite skipempty
syntax region asemeComment_1029 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1027,asemeComment_1029 skipwhite skipempty
syntax match asemeComment_1029 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1027,asemeComment_1029 skipwhite skipempty
syntax match asemeReference_1027 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1025 /\vwrites%(<|>)/ contained nextgroup=asemeReference_1024,asemeComment_1026 skipwhite skipempty
syntax region asemeComment_1026 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1024,asemeComment_1026 skipwhite skipempty
syntax match asemeComment_1026 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1024,asemeComment_1026 skipwhite skipempty
syntax match asemeReference_1024 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1022 /\vfor%(<|>)/ contained nextgroup=asemeNumber_1021,asemeComment_1023 skipwhite skipempty
syntax region asemeComment_1023 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1021,asemeComment_1023 skipwhite skipempty
syntax match asemeComment_1023 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1021,asemeComment_1023 skipwhite skipempty
syntax match asemeNumber_1021 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeChoice_1019 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1018,asemeComment_1020 skipwhite skipempty
syntax region asemeComment_1020 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1018,asemeComment_1020 skipwhite skipempty
syntax match asemeComment_1020 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1018,asemeComment_1020 skipwhite skipempty
syntax match asemeReference_1018 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1016 /\vuses%(<|>)/ contained nextgroup=asemeReference_1015,asemeComment_1017 skipwhite skipempty
syntax region asemeComment_1017 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1015,asemeComment_1017 skipwhite skipempty
syntax match asemeComment_1017 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1015,asemeComment_1017 skipwhite skipempty
syntax match asemeReference_1015 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1013 /\vas%(<|>)/ contained nextgroup=asemeChoice_1012,asemeComment_1014 skipwhite skipempty
syntax region asemeComment_1014 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1012,asemeComment_1014 skipwhite skipempty
syntax match asemeComment_1014 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1012,asemeComment_1014 skipwhite skipempty
syntax match asemeChoice_1012 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1010 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_1009,asemeComment_1011 skipwhite skipempty
syntax region asemeComment_1011 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1009,asemeComment_1011 skipwhite skipempty
syntax match asemeComment_1011 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1009,asemeComment_1011 skipwhite skipempty
syntax match asemeNumber_1009 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1007 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_1006,asemeComment_1008 skipwhite skipempty
syntax region asemeComment_1008 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1006,asemeComment_1008 skipwhite skipempty
syntax match asemeComment_1008 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1006,asemeComment_1008 skipwhite skipempty
syntax match asemeNumber_1006 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1004 /\vevery%(<|>)/ contained nextgroup=asemeNumber_1003,asemeComment_1005 skipwhite skipempty
syntax region asemeComment_1005 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1003,asemeComment_1005 skipwhite skipempty
syntax match asemeComment_1005 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1003,asemeComment_1005 skipwhite skipempty
syntax match asemeNumber_1003 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeClause_1001 /\vreads%(<|>)/ contained nextgroup=asemeChoice_998,asemeReference_1000,asemeComment_1002 skipwhite skipempty
syntax region asemeComment_1002 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_998,asemeReference_1000,asemeComment_1002 skipwhite skipempty
syntax match asemeComment_1002 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_998,asemeReference_1000,asemeComment_1002 skipwhite skipempty
syntax match asemeReference_1000 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeChoice_998 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_996,asemeComment_999 skipwhite skipempty
syntax region asemeComment_999 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_996,asemeComment_999 skipwhite skipempty
syntax match asemeComment_999 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_996,asemeComment_999 skipwhite skipempty
syntax match asemeReference_996 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax region asemeComment_997 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeComment_997 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_997 skipwhite skipempty
syntax match asemeDeclaration_994 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_995 skipwhite skipempty
syntax region asemeComment_995 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_995 skipwhite skipempty
syntax match asemeComment_995 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_995 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_993
syntax region asemePunctuation_993 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_992,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeName_992 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_932,asemeClause_935,asemeClause_938,asemeClause_941,asemeClause_944,asemeClause_947,asemeChoice_950,asemeClause_953,asemeClause_956,asemeClause_959,asemeClause_961,asemeChoice_962,asemeChoice_963,asemePunctuation_970,asemePunctuation_984,asemePunctuation_988,asemePunctuation_990,asemeReference_991
syntax match asemeReference_991 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemePunctuation_990 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemePunctuation_988 /\v\:/ contained nextgroup=asemeBuiltIn_986,asemeType_987,asemeComment_989 skipwhite skipempty
syntax region asemeComment_989 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_986,asemeType_987,asemeComment_989 skipwhite skipempty
syntax match asemeComment_989 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_986,asemeType_987,asemeComment_989 skipwhite skipempty
syntax match asemeType_987 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeBuiltIn_986 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemePunctuation_984 /\v\,/ contained nextgroup=asemeName_976,asemeChoice_979,asemeReference_981,asemeReference_982,asemeReference_983,asemeComment_985 skipwhite skipempty
syntax region asemeComment_985 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_976,asemeChoice_979,asemeReference_981,asemeReference_982,asemeReference_983,asemeComment_985 skipwhite skipempty
syntax match asemeComment_985 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_976,asemeChoice_979,asemeReference_981,asemeReference_982,asemeReference_983,asemeComment_985 skipwhite skipempty
syntax match asemeReference_983 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeReference_982 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeReference_981 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeChoice_979 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_978,asemeComment_980 skipwhite skipempty
syntax region asemeComment_980 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_978,asemeComment_980 skipwhite skipempty
syntax match asemeComment_980 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_978,asemeComment_980 skipwhite skipempty
syntax match asemeReference_978 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeName_976 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_974,asemeComment_977 skipwhite skipempty
syntax region asemeComment_977 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_974,asemeComment_977 skipwhite skipempty
syntax match asemeComment_977 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_974,asemeComment_977 skipwhite skipempty
syntax match asemePunctuation_974 /\v\:/ contained nextgroup=asemeBuiltIn_972,asemeType_973,asemeComment_975 skipwhite skipempty
syntax region asemeComment_975 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_972,asemeType_973,asemeComment_975 skipwhite skipempty
syntax match asemeComment_975 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_972,asemeType_973,asemeComment_975 skipwhite skipempty
syntax match asemeType_973 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeBuiltIn_972 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemePunctuation_970 /\v\(/ contained nextgroup=asemeName_968,asemeComment_971 skipwhite skipempty
syntax region asemeComment_971 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_968,asemeComment_971 skipwhite skipempty
syntax match asemeComment_971 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_968,asemeComment_971 skipwhite skipempty
syntax match asemeName_968 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_966,asemeComment_969 skipwhite skipempty
syntax region asemeComment_969 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_966,asemeComment_969 skipwhite skipempty
syntax match asemeComment_969 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_966,asemeComment_969 skipwhite skipempty
syntax match asemePunctuation_966 /\v\:/ contained nextgroup=asemeBuiltIn_964,asemeType_965,asemeComment_967 skipwhite skipempty
syntax region asemeComment_967 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_964,asemeType_965,asemeComment_967 skipwhite skipempty
syntax match asemeComment_967 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_964,asemeType_965,asemeComment_967 skipwhite skipempty
syntax match asemeType_965 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeBuiltIn_964 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeChoice_963 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeChoice_962 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_961 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_959 /\vends%(<|>)/ contained nextgroup=asemeReference_958,asemeComment_960 skipwhite skipempty
syntax region asemeComment_960 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_958,asemeComment_960 skipwhite skipempty
syntax match asemeComment_960 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_958,asemeComment_960 skipwhite skipempty
syntax match asemeReference_958 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_956 /\vwrites%(<|>)/ contained nextgroup=asemeReference_955,asemeComment_957 skipwhite skipempty
syntax region asemeComment_957 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_955,asemeComment_957 skipwhite skipempty
syntax match asemeComment_957 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_955,asemeComment_957 skipwhite skipempty
syntax match asemeReference_955 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_953 /\vfor%(<|>)/ contained nextgroup=asemeNumber_952,asemeComment_954 skipwhite skipempty
syntax region asemeComment_954 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_952,asemeComment_954 skipwhite skipempty
syntax match asemeComment_954 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_952,asemeComment_954 skipwhite skipempty
syntax match asemeNumber_952 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeChoice_950 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_949,asemeComment_951 skipwhite skipempty
syntax region asemeComment_951 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_949,asemeComment_951 skipwhite skipempty
syntax match asemeComment_951 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_949,asemeComment_951 skipwhite skipempty
syntax match asemeReference_949 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_947 /\vuses%(<|>)/ contained nextgroup=asemeReference_946,asemeComment_948 skipwhite skipempty
syntax region asemeComment_948 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_946,asemeComment_948 skipwhite skipempty
syntax match asemeComment_948 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_946,asemeComment_948 skipwhite skipempty
syntax match asemeReference_946 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_944 /\vas%(<|>)/ contained nextgroup=asemeChoice_943,asemeComment_945 skipwhite skipempty
syntax region asemeComment_945 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_943,asemeComment_945 skipwhite skipempty
syntax match asemeComment_945 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_943,asemeComment_945 skipwhite skipempty
syntax match asemeChoice_943 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_941 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_940,asemeComment_942 skipwhite skipempty
syntax region asemeComment_942 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_940,asemeComment_942 skipwhite skipempty
syntax match asemeComment_942 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_940,asemeComment_942 skipwhite skipempty
syntax match asemeNumber_940 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_938 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_937,asemeComment_939 skipwhite skipempty
syntax region asemeComment_939 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_937,asemeComment_939 skipwhite skipempty
syntax match asemeComment_939 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_937,asemeComment_939 skipwhite skipempty
syntax match asemeNumber_937 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_935 /\vevery%(<|>)/ contained nextgroup=asemeNumber_934,asemeComment_936 skipwhite skipempty
syntax region asemeComment_936 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_934,asemeComment_936 skipwhite skipempty
syntax match asemeComment_936 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_934,asemeComment_936 skipwhite skipempty
syntax match asemeNumber_934 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeClause_932 /\vreads%(<|>)/ contained nextgroup=asemeChoice_929,asemeReference_931,asemeComment_933 skipwhite skipempty
syntax region asemeComment_933 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_929,asemeReference_931,asemeComment_933 skipwhite skipempty
syntax match asemeComment_933 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_929,asemeReference_931,asemeComment_933 skipwhite skipempty
syntax match asemeReference_931 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeChoice_929 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_927,asemeComment_930 skipwhite skipempty
syntax region asemeComment_930 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_927,asemeComment_930 skipwhite skipempty
syntax match asemeComment_930 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_927,asemeComment_930 skipwhite skipempty
syntax match asemeReference_927 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax region asemeComment_928 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeComment_928 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_928 skipwhite skipempty
syntax match asemeDeclaration_925 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_926 skipwhite skipempty
syntax region asemeComment_926 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_926 skipwhite skipempty
syntax match asemeComment_926 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_926 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_924
syntax region asemePunctuation_924 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_923,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeName_923 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_905,asemePunctuation_909,asemePunctuation_912,asemePunctuation_914,asemeOperator_922
syntax match asemeOperator_922 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemePunctuation_914 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax match asemePunctuation_912 /\v\,/ contained nextgroup=asemeName_911,asemeComment_913 skipwhite skipempty
syntax region asemeComment_913 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_911,asemeComment_913 skipwhite skipempty
syntax match asemeComment_913 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_911,asemeComment_913 skipwhite skipempty
syntax match asemeName_911 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax match asemePunctuation_909 /\v\:/ contained nextgroup=asemeBuiltIn_907,asemeType_908,asemeComment_910 skipwhite skipempty
syntax region asemeComment_910 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_907,asemeType_908,asemeComment_910 skipwhite skipempty
syntax match asemeComment_910 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_907,asemeType_908,asemeComment_910 skipwhite skipempty
syntax match asemeType_908 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax match asemeBuiltIn_907 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax match asemePunctuation_905 /\v\(/ contained nextgroup=asemeName_903,asemeComment_906 skipwhite skipempty
syntax region asemeComment_906 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_903,asemeComment_906 skipwhite skipempty
syntax match asemeComment_906 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_903,asemeComment_906 skipwhite skipempty
syntax match asemeName_903 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax region asemeComment_904 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax match asemeComment_904 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_904 skipwhite skipempty
syntax match asemeDeclaration_901 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_899,asemeComment_902 skipwhite skipempty
syntax region asemeComment_902 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_899,asemeComment_902 skipwhite skipempty
syntax match asemeComment_902 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_899,asemeComment_902 skipwhite skipempty
syntax match asemeName_899 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_898,asemeComment_900 skipwhite skipempty
syntax region asemeComment_900 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_898,asemeComment_900 skipwhite skipempty
syntax match asemeComment_900 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_898,asemeComment_900 skipwhite skipempty
syntax match asemeOperator_898 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeDeclaration_896 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_895,asemeComment_897 skipwhite skipempty
syntax region asemeComment_897 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_895,asemeComment_897 skipwhite skipempty
syntax match asemeComment_897 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_895,asemeComment_897 skipwhite skipempty
syntax match asemeName_895 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemeClause_839,asemeClause_841,asemePunctuation_845,asemeNumber_850,asemePunctuation_855,asemePunctuation_858,asemePunctuation_860,asemeOperator_893,asemeName_894
syntax match asemeName_894 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeOperator_893 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemePunctuation_860 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemePunctuation_858 /\v\.\./ contained nextgroup=asemeNumber_857,asemeComment_859 skipwhite skipempty
syntax region asemeComment_859 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_857,asemeComment_859 skipwhite skipempty
syntax match asemeComment_859 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_857,asemeComment_859 skipwhite skipempty
syntax match asemeNumber_857 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemePunctuation_855 /\v\:/ contained nextgroup=asemeClause_852,asemeBuiltIn_853,asemeType_854,asemeComment_856 skipwhite skipempty
syntax region asemeComment_856 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_852,asemeBuiltIn_853,asemeType_854,asemeComment_856 skipwhite skipempty
syntax match asemeComment_856 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_852,asemeBuiltIn_853,asemeType_854,asemeComment_856 skipwhite skipempty
syntax match asemeType_854 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeBuiltIn_853 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeClause_852 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeNumber_850 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_848,asemeComment_851 skipwhite skipempty
syntax region asemeComment_851 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_848,asemeComment_851 skipwhite skipempty
syntax match asemeComment_851 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_848,asemeComment_851 skipwhite skipempty
syntax match asemePunctuation_848 /\v\.\./ contained nextgroup=asemeNumber_847,asemeComment_849 skipwhite skipempty
syntax region asemeComment_849 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_847,asemeComment_849 skipwhite skipempty
syntax match asemeComment_849 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_847,asemeComment_849 skipwhite skipempty
syntax match asemeNumber_847 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemePunctuation_845 /\v\[/ contained nextgroup=asemeNumber_843,asemeComment_846 skipwhite skipempty
syntax region asemeComment_846 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_843,asemeComment_846 skipwhite skipempty
syntax match asemeComment_846 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_843,asemeComment_846 skipwhite skipempty
syntax match asemeNumber_843 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax region asemeComment_844 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax match asemeComment_844 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_842,asemeComment_844 skipwhite skipempty
syntax match asemePunctuation_842 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeClause_841 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeClause_839 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_836,asemeType_838,asemeComment_840 skipwhite skipempty
syntax region asemeComment_840 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_836,asemeType_838,asemeComment_840 skipwhite skipempty
syntax match asemeComment_840 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_836,asemeType_838,asemeComment_840 skipwhite skipempty
syntax match asemeType_838 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeBuiltIn_836 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_837 skipwhite skipempty
syntax match asemeDeclaration_834 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_832,asemeComment_835 skipwhite skipempty
syntax region asemeComment_835 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_832,asemeComment_835 skipwhite skipempty
syntax match asemeComment_835 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_832,asemeComment_835 skipwhite skipempty
syntax match asemeName_832 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_831,@asemeCapabilityInBodyOfSrm,asemeComment_833 skipwhite skipempty
syntax region asemeComment_833 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_831,@asemeCapabilityInBodyOfSrm,asemeComment_833 skipwhite skipempty
syntax match asemeComment_833 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_831,@asemeCapabilityInBodyOfSrm,asemeComment_833 skipwhite skipempty
syntax match asemeText_831 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_822,asemePunctuation_825,asemeText_827,asemeName_829
syntax match asemeName_829 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_828,@asemeCapabilityInBodyOfSrm,asemeComment_830 skipwhite skipempty
syntax region asemeComment_830 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_828,@asemeCapabilityInBodyOfSrm,asemeComment_830 skipwhite skipempty
syntax match asemeComment_830 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_828,@asemeCapabilityInBodyOfSrm,asemeComment_830 skipwhite skipempty
syntax match asemeText_828 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax match asemeText_827 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax match asemePunctuation_825 /\v\,/ contained nextgroup=asemeReference_824,asemeComment_826 skipwhite skipempty
syntax region asemeComment_826 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_824,asemeComment_826 skipwhite skipempty
syntax match asemeComment_826 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_824,asemeComment_826 skipwhite skipempty
syntax match asemeReference_824 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax match asemeOperator_822 /\v\=%(\=)@!/ contained nextgroup=asemeReference_820,asemeComment_823 skipwhite skipempty
syntax region asemeComment_823 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_820,asemeComment_823 skipwhite skipempty
syntax match asemeComment_823 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_820,asemeComment_823 skipwhite skipempty
syntax match asemeReference_820 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax region asemeComment_821 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax match asemeComment_821 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_821 skipwhite skipempty
syntax match asemeDeclaration_818 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_816,asemeComment_819 skipwhite skipempty
syntax region asemeComment_819 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_816,asemeComment_819 skipwhite skipempty
syntax match asemeComment_819 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_816,asemeComment_819 skipwhite skipempty
syntax match asemeReference_816 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_814,asemeComment_817 skipwhite skipempty
syntax region asemeComment_817 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_814,asemeComment_817 skipwhite skipempty
syntax match asemeComment_817 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_814,asemeComment_817 skipwhite skipempty
syntax match asemePunctuation_814 /\v\./ contained nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax region asemeComment_815 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax match asemeComment_815 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax match asemeReference_813 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_756,asemeClause_760,asemeClause_790,asemeClause_792,asemePunctuation_801,asemePunctuation_804,asemeOperator_806,asemeReference_810,asemeReference_812
syntax match asemeReference_812 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax match asemeReference_810 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_808,asemeComment_811 skipwhite skipempty
syntax region asemeComment_811 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_808,asemeComment_811 skipwhite skipempty
syntax match asemeComment_811 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_808,asemeComment_811 skipwhite skipempty
syntax match asemePunctuation_808 /\v\./ contained nextgroup=asemeReference_807,asemeComment_809 skipwhite skipempty
syntax region asemeComment_809 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_807,asemeComment_809 skipwhite skipempty
syntax match asemeComment_809 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_807,asemeComment_809 skipwhite skipempty
syntax match asemeReference_807 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax match asemeOperator_806 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemePunctuation_804 /\v\./ contained nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax region asemeComment_805 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax match asemeComment_805 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax match asemeReference_803 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax match asemePunctuation_801 /\v\,/ contained nextgroup=asemeReference_796,asemeReference_799,asemeComment_802 skipwhite skipempty
syntax region asemeComment_802 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_796,asemeReference_799,asemeComment_802 skipwhite skipempty
syntax match asemeComment_802 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_796,asemeReference_799,asemeComment_802 skipwhite skipempty
syntax match asemeReference_799 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_798,asemeComment_800 skipwhite skipempty
syntax region asemeComment_800 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_798,asemeComment_800 skipwhite skipempty
syntax match asemeComment_800 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_798,asemeComment_800 skipwhite skipempty
syntax match asemeOperator_798 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeReference_796 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_794,asemeComment_797 skipwhite skipempty
syntax region asemeComment_797 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_794,asemeComment_797 skipwhite skipempty
syntax match asemeComment_797 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_794,asemeComment_797 skipwhite skipempty
syntax match asemePunctuation_794 /\v\./ contained nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax region asemeComment_795 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax match asemeComment_795 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax match asemeReference_793 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax match asemeClause_792 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_790 /\vwhen%(<|>)/ contained nextgroup=asemeClause_789,asemeComment_791 skipwhite skipempty
syntax region asemeComment_791 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_789,asemeComment_791 skipwhite skipempty
syntax match asemeComment_791 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_789,asemeComment_791 skipwhite skipempty
syntax match asemeClause_789 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_760 /\vas%(<|>)/ contained nextgroup=asemeReference_758,asemeComment_761 skipwhite skipempty
syntax region asemeComment_761 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_758,asemeComment_761 skipwhite skipempty
syntax match asemeComment_761 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_758,asemeComment_761 skipwhite skipempty
syntax match asemeReference_758 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax region asemeComment_759 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax match asemeComment_759 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_759 skipwhite skipempty
syntax match asemeClause_756 /\vwith%(<|>)/ contained nextgroup=asemeReference_754,asemeComment_757 skipwhite skipempty
syntax region asemeComment_757 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_754,asemeComment_757 skipwhite skipempty
syntax match asemeComment_757 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_754,asemeComment_757 skipwhite skipempty
syntax match asemeReference_754 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_753,asemeComment_755 skipwhite skipempty
syntax region asemeComment_755 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_753,asemeComment_755 skipwhite skipempty
syntax match asemeComment_755 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_753,asemeComment_755 skipwhite skipempty
syntax match asemeOperator_753 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeDeclaration_719 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_718,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_718,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_718,asemeComment_720 skipwhite skipempty
syntax match asemeReference_718 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_714 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_715,asemeReference_717
syntax match asemeReference_717 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_714 skipwhite skipempty
syntax match asemePunctuation_715 /\v\,/ contained nextgroup=asemeReference_713,asemeComment_716 skipwhite skipempty
syntax region asemeComment_716 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_713,asemeComment_716 skipwhite skipempty
syntax match asemeComment_716 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_713,asemeComment_716 skipwhite skipempty
syntax match asemeReference_713 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_714 skipwhite skipempty
syntax region asemeComment_714 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_714 skipwhite skipempty
syntax match asemeComment_714 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_714 skipwhite skipempty
syntax match asemeClause_711 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_709,asemeComment_712 skipwhite skipempty
syntax region asemeComment_712 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_709,asemeComment_712 skipwhite skipempty
syntax match asemeComment_712 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_709,asemeComment_712 skipwhite skipempty
syntax match asemeBlock_709 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_710 skipwhite skipempty
syntax region asemeComment_710 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_710 skipwhite skipempty
syntax match asemeComment_710 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_710 skipwhite skipempty
syntax match asemeDeclaration_707 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_706,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_706,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_706,asemeComment_708 skipwhite skipempty
syntax match asemeBlock_706 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_705 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_703,asemeBlock_704
syntax match asemeBlock_704 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_705 skipwhite skipempty
syntax region asemeComment_705 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_705 skipwhite skipempty
syntax match asemeComment_705 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_705 skipwhite skipempty
syntax region asemePunctuation_703 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_555,asemeDeclaration_558,asemeDeclaration_591,asemeDeclaration_595,asemeDeclaration_701,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_701 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_699,asemeComment_702 skipwhite skipempty
syntax region asemeComment_702 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_699,asemeComment_702 skipwhite skipempty
syntax match asemeComment_702 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_699,asemeComment_702 skipwhite skipempty
syntax match asemeBlock_699 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_696,asemeOperator_698,@asemeControlInBodyOfAip,asemeComment_700 skipwhite skipempty
syntax region asemeComment_700 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_696,asemeOperator_698,@asemeControlInBodyOfAip,asemeComment_700 skipwhite skipempty
syntax match asemeComment_700 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_696,asemeOperator_698,@asemeControlInBodyOfAip,asemeComment_700 skipwhite skipempty
syntax match asemeOperator_698 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax match asemeOperator_696 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_695,@asemeControlInBodyOfAip,asemeComment_697 skipwhite skipempty
syntax region asemeComment_697 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_695,@asemeControlInBodyOfAip,asemeComment_697 skipwhite skipempty
syntax match asemeComment_697 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_695,@asemeControlInBodyOfAip,asemeComment_697 skipwhite skipempty
syntax match asemeOperator_695 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemeOperator_599,asemePunctuation_687,asemeOperator_688,asemeBlock_693
syntax match asemeBlock_693 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_690,asemeOperator_692,@asemeControlInBodyOfAip,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_690,asemeOperator_692,@asemeControlInBodyOfAip,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_690,asemeOperator_692,@asemeControlInBodyOfAip,asemeComment_694 skipwhite skipempty
syntax match asemeOperator_692 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax match asemeOperator_690 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_689,@asemeControlInBodyOfAip,asemeComment_691 skipwhite skipempty
syntax region asemeComment_691 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_689,@asemeControlInBodyOfAip,asemeComment_691 skipwhite skipempty
syntax match asemeComment_691 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_689,@asemeControlInBodyOfAip,asemeComment_691 skipwhite skipempty
syntax match asemeOperator_689 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax match asemeOperator_688 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax region asemePunctuation_687 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_647,asemeNumber_685,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeNumber_685 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_683,asemeComment_686 skipwhite skipempty
syntax region asemeComment_686 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_683,asemeComment_686 skipwhite skipempty
syntax match asemeComment_686 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_683,asemeComment_686 skipwhite skipempty
syntax match asemeOperator_683 /\v\-\>/ contained nextgroup=asemeNumber_681,asemeComment_684 skipwhite skipempty
syntax region asemeComment_684 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_681,asemeComment_684 skipwhite skipempty
syntax match asemeComment_684 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_681,asemeComment_684 skipwhite skipempty
syntax match asemeNumber_681 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_680,asemeComment_682 skipwhite skipempty
syntax region asemeComment_682 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_680,asemeComment_682 skipwhite skipempty
syntax match asemeComment_682 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_680,asemeComment_682 skipwhite skipempty
syntax match asemePunctuation_680 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeDeclaration_647 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_603,asemeOperator_606,asemePunctuation_640,asemeText_641,asemeNumber_642,asemeReference_643,asemeNumber_644,asemeOperator_645,asemePunctuation_646
syntax match asemePunctuation_646 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeOperator_645 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeNumber_644 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeReference_643 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeNumber_642 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeText_641 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemePunctuation_640 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeOperator_606 /\v\#/ contained nextgroup=asemeNumber_605,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_605,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_605,asemeComment_607 skipwhite skipempty
syntax match asemeNumber_605 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeClause_603 /\vevery%(<|>)/ contained nextgroup=asemeNumber_601,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_601,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_601,asemeComment_604 skipwhite skipempty
syntax match asemeNumber_601 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax region asemeComment_602 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeComment_602 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_602 skipwhite skipempty
syntax match asemeOperator_599 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_597,@asemeControlInBodyOfAip,asemeComment_600 skipwhite skipempty
syntax region asemeComment_600 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_597,@asemeControlInBodyOfAip,asemeComment_600 skipwhite skipempty
syntax match asemeComment_600 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_597,@asemeControlInBodyOfAip,asemeComment_600 skipwhite skipempty
syntax match asemeOperator_597 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_598 skipwhite skipempty
syntax match asemeDeclaration_595 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_593,asemeComment_596 skipwhite skipempty
syntax region asemeComment_596 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_593,asemeComment_596 skipwhite skipempty
syntax match asemeComment_596 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_593,asemeComment_596 skipwhite skipempty
syntax match asemeName_593 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_592,asemeComment_594 skipwhite skipempty
syntax region asemeComment_594 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_592,asemeComment_594 skipwhite skipempty
syntax match asemeComment_594 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_592,asemeComment_594 skipwhite skipempty
syntax match asemeOperator_592 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeDeclaration_591 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_565,asemeClause_569,asemeClause_572,asemeClause_575,asemeClause_578,asemeClause_580,asemeClause_581,asemeClause_582,asemePunctuation_584,asemeOperator_587,asemePunctuation_589,asemeName_590
syntax match asemeName_590 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemePunctuation_589 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeOperator_587 /\v\@/ contained nextgroup=asemeReference_586,asemeComment_588 skipwhite skipempty
syntax region asemeComment_588 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_586,asemeComment_588 skipwhite skipempty
syntax match asemeComment_588 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_586,asemeComment_588 skipwhite skipempty
syntax match asemeReference_586 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemePunctuation_584 /\v\(/ contained nextgroup=asemeName_583,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_583,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_583,asemeComment_585 skipwhite skipempty
syntax match asemeName_583 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_582 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_581 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_580 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_578 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_577,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_577,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_577,asemeComment_579 skipwhite skipempty
syntax match asemeNumber_577 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_575 /\vleads%(<|>)/ contained nextgroup=asemeClause_574,asemeComment_576 skipwhite skipempty
syntax region asemeComment_576 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_574,asemeComment_576 skipwhite skipempty
syntax match asemeComment_576 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_574,asemeComment_576 skipwhite skipempty
syntax match asemeClause_574 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_572 /\vor%(<|>)/ contained nextgroup=asemeName_571,asemeComment_573 skipwhite skipempty
syntax region asemeComment_573 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_571,asemeComment_573 skipwhite skipempty
syntax match asemeComment_573 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_571,asemeComment_573 skipwhite skipempty
syntax match asemeName_571 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_569 /\vmost%(<|>)/ contained nextgroup=asemeChoice_567,asemeNumber_568,asemeComment_570 skipwhite skipempty
syntax region asemeComment_570 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_567,asemeNumber_568,asemeComment_570 skipwhite skipempty
syntax match asemeComment_570 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_567,asemeNumber_568,asemeComment_570 skipwhite skipempty
syntax match asemeNumber_568 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeChoice_567 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeClause_565 /\vat%(<|>)/ contained nextgroup=asemeClause_563,asemeComment_566 skipwhite skipempty
syntax region asemeComment_566 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_563,asemeComment_566 skipwhite skipempty
syntax match asemeComment_566 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_563,asemeComment_566 skipwhite skipempty
syntax match asemeClause_563 /\vmost%(<|>)/ contained nextgroup=asemeChoice_560,asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax region asemeComment_564 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_560,asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax match asemeComment_564 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_560,asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax match asemeNumber_562 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeChoice_560 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax region asemeComment_561 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeComment_561 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_561 skipwhite skipempty
syntax match asemeDeclaration_558 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_557,asemeComment_559 skipwhite skipempty
syntax region asemeComment_559 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_557,asemeComment_559 skipwhite skipempty
syntax match asemeComment_559 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_557,asemeComment_559 skipwhite skipempty
syntax match asemeText_557 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_555 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_554,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_554,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_554,asemeComment_556 skipwhite skipempty
syntax match asemeBlock_554 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_251,asemePunctuation_254,asemePunctuation_256,asemePunctuation_552,asemeBlock_553
syntax match asemeBlock_553 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax region asemePunctuation_552 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_258,asemeDeclaration_357,asemeDeclaration_419,asemeDeclaration_427,asemeDeclaration_489,asemeDeclaration_494,asemeDeclaration_515,asemeDeclaration_529,asemeName_551,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeName_551 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_533,asemePunctuation_537,asemePunctuation_540,asemePunctuation_542,asemeOperator_550
syntax match asemeOperator_550 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemePunctuation_542 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax match asemePunctuation_540 /\v\,/ contained nextgroup=asemeName_539,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_539,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_539,asemeComment_541 skipwhite skipempty
syntax match asemeName_539 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax match asemePunctuation_537 /\v\:/ contained nextgroup=asemeBuiltIn_535,asemeType_536,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_535,asemeType_536,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_535,asemeType_536,asemeComment_538 skipwhite skipempty
syntax match asemeType_536 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax match asemeBuiltIn_535 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax match asemePunctuation_533 /\v\(/ contained nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax region asemeComment_534 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax match asemeComment_534 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax match asemeName_531 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_532 skipwhite skipempty
syntax match asemeDeclaration_529 /\v%(receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_527,asemeComment_530 skipwhite skipempty
syntax region asemeComment_530 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_527,asemeComment_530 skipwhite skipempty
syntax match asemeComment_530 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_527,asemeComment_530 skipwhite skipempty
syntax match asemeReference_527 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_526,asemeComment_528 skipwhite skipempty
syntax region asemeComment_528 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_526,asemeComment_528 skipwhite skipempty
syntax match asemeComment_528 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_526,asemeComment_528 skipwhite skipempty
syntax match asemeReference_526 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_518 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_521,asemeReference_524
syntax match asemeReference_524 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_523,@asemeReceivesInBodyOfParticipant,asemeComment_525 skipwhite skipempty
syntax region asemeComment_525 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_523,@asemeReceivesInBodyOfParticipant,asemeComment_525 skipwhite skipempty
syntax match asemeComment_525 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_523,@asemeReceivesInBodyOfParticipant,asemeComment_525 skipwhite skipempty
syntax match asemeReference_523 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_518 skipwhite skipempty
syntax match asemePunctuation_521 /\v\,/ contained nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax region asemeComment_522 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax match asemeComment_522 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax match asemeReference_519 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_517,asemeComment_520 skipwhite skipempty
syntax region asemeComment_520 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_517,asemeComment_520 skipwhite skipempty
syntax match asemeComment_520 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_517,asemeComment_520 skipwhite skipempty
syntax match asemeReference_517 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_518 skipwhite skipempty
syntax region asemeComment_518 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_518 skipwhite skipempty
syntax match asemeComment_518 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_518 skipwhite skipempty
syntax match asemeDeclaration_515 /\v%(sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_513,asemeComment_516 skipwhite skipempty
syntax region asemeComment_516 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_513,asemeComment_516 skipwhite skipempty
syntax match asemeComment_516 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_513,asemeComment_516 skipwhite skipempty
syntax match asemeReference_513 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax match asemeReference_512 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_498,asemeClause_501,asemeClause_503,asemePunctuation_507,asemeReference_510
syntax match asemeReference_510 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_509,@asemeSendsInBodyOfParticipant,asemeComment_511 skipwhite skipempty
syntax region asemeComment_511 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_509,@asemeSendsInBodyOfParticipant,asemeComment_511 skipwhite skipempty
syntax match asemeComment_511 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_509,@asemeSendsInBodyOfParticipant,asemeComment_511 skipwhite skipempty
syntax match asemeReference_509 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax match asemePunctuation_507 /\v\,/ contained nextgroup=asemeReference_505,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_505,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_505,asemeComment_508 skipwhite skipempty
syntax match asemeReference_505 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax region asemeComment_506 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax match asemeComment_506 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_504,asemeComment_506 skipwhite skipempty
syntax match asemeReference_504 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax match asemeClause_503 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax match asemeClause_501 /\vor%(<|>)/ contained nextgroup=asemeReference_500,asemeComment_502 skipwhite skipempty
syntax region asemeComment_502 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_500,asemeComment_502 skipwhite skipempty
syntax match asemeComment_502 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_500,asemeComment_502 skipwhite skipempty
syntax match asemeReference_500 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax match asemeClause_498 /\vby%(<|>)/ contained nextgroup=asemeReference_496,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_496,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_496,asemeComment_499 skipwhite skipempty
syntax match asemeReference_496 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax region asemeComment_497 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax match asemeComment_497 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_497 skipwhite skipempty
syntax match asemeDeclaration_494 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_492,asemeComment_495 skipwhite skipempty
syntax region asemeComment_495 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_492,asemeComment_495 skipwhite skipempty
syntax match asemeComment_495 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_492,asemeComment_495 skipwhite skipempty
syntax match asemeName_492 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_491,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_491,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_491,asemeComment_493 skipwhite skipempty
syntax match asemeOperator_491 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeDeclaration_489 /\v%(result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=result%(<|>)/ contained nextgroup=asemeName_487,asemeComment_490 skipwhite skipempty
syntax region asemeComment_490 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_487,asemeComment_490 skipwhite skipempty
syntax match asemeComment_490 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_487,asemeComment_490 skipwhite skipempty
syntax match asemeName_487 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_485,asemeComment_488 skipwhite skipempty
syntax region asemeComment_488 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_485,asemeComment_488 skipwhite skipempty
syntax match asemeComment_488 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_485,asemeComment_488 skipwhite skipempty
syntax match asemePunctuation_485 /\v\:/ contained nextgroup=asemeBuiltIn_483,asemeType_484,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_483,asemeType_484,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_483,asemeType_484,asemeComment_486 skipwhite skipempty
syntax match asemeType_484 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeBuiltIn_483 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax cluster asemeResultInBodyOfParticipant contains=asemeNumber_433,asemePunctuation_436,asemePunctuation_440,asemeOperator_474,asemeName_479,asemeBuiltIn_481,asemeType_482
syntax match asemeType_482 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeBuiltIn_481 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeName_479 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_477,asemeComment_480 skipwhite skipempty
syntax region asemeComment_480 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_477,asemeComment_480 skipwhite skipempty
syntax match asemeComment_480 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_477,asemeComment_480 skipwhite skipempty
syntax match asemePunctuation_477 /\v\:/ contained nextgroup=asemeBuiltIn_475,asemeType_476,asemeComment_478 skipwhite skipempty
syntax region asemeComment_478 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_475,asemeType_476,asemeComment_478 skipwhite skipempty
syntax match asemeComment_478 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_475,asemeType_476,asemeComment_478 skipwhite skipempty
syntax match asemeType_476 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeBuiltIn_475 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeOperator_474 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemePunctuation_440 /\v\:/ contained nextgroup=asemeBuiltIn_438,asemeType_439,asemeComment_441 skipwhite skipempty
syntax region asemeComment_441 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_438,asemeType_439,asemeComment_441 skipwhite skipempty
syntax match asemeComment_441 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_438,asemeType_439,asemeComment_441 skipwhite skipempty
syntax match asemeType_439 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeBuiltIn_438 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemePunctuation_436 /\v\.\./ contained nextgroup=asemeNumber_435,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_435,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_435,asemeComment_437 skipwhite skipempty
syntax match asemeNumber_435 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeNumber_433 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_431,asemeComment_434 skipwhite skipempty
syntax region asemeComment_434 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_431,asemeComment_434 skipwhite skipempty
syntax match asemeComment_434 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_431,asemeComment_434 skipwhite skipempty
syntax match asemePunctuation_431 /\v\.\./ contained nextgroup=asemeNumber_429,asemeComment_432 skipwhite skipempty
syntax region asemeComment_432 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_429,asemeComment_432 skipwhite skipempty
syntax match asemeComment_432 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_429,asemeComment_432 skipwhite skipempty
syntax match asemeNumber_429 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax region asemeComment_430 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeComment_430 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_430 skipwhite skipempty
syntax match asemeDeclaration_427 /\v%(given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=given%(<|>)/ contained nextgroup=asemeName_425,asemeComment_428 skipwhite skipempty
syntax region asemeComment_428 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_425,asemeComment_428 skipwhite skipempty
syntax match asemeComment_428 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_425,asemeComment_428 skipwhite skipempty
syntax match asemeName_425 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_423,asemeComment_426 skipwhite skipempty
syntax region asemeComment_426 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_423,asemeComment_426 skipwhite skipempty
syntax match asemeComment_426 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_423,asemeComment_426 skipwhite skipempty
syntax match asemePunctuation_423 /\v\:/ contained nextgroup=asemeBuiltIn_421,asemeType_422,asemeComment_424 skipwhite skipempty
syntax region asemeComment_424 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_421,asemeType_422,asemeComment_424 skipwhite skipempty
syntax match asemeComment_424 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_421,asemeType_422,asemeComment_424 skipwhite skipempty
syntax match asemeType_422 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained
syntax match asemeBuiltIn_421 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained
syntax match asemeDeclaration_419 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_418,asemeComment_420 skipwhite skipempty
syntax region asemeComment_420 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_418,asemeComment_420 skipwhite skipempty
syntax match asemeComment_420 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_418,asemeComment_420 skipwhite skipempty
syntax match asemeName_418 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemeClause_362,asemeClause_364,asemePunctuation_368,asemeNumber_373,asemePunctuation_378,asemePunctuation_381,asemePunctuation_383,asemeOperator_416,asemeName_417
syntax match asemeName_417 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeOperator_416 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemePunctuation_383 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemePunctuation_381 /\v\.\./ contained nextgroup=asemeNumber_380,asemeComment_382 skipwhite skipempty
syntax region asemeComment_382 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_380,asemeComment_382 skipwhite skipempty
syntax match asemeComment_382 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_380,asemeComment_382 skipwhite skipempty
syntax match asemeNumber_380 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemePunctuation_378 /\v\:/ contained nextgroup=asemeClause_375,asemeBuiltIn_376,asemeType_377,asemeComment_379 skipwhite skipempty
syntax region asemeComment_379 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_375,asemeBuiltIn_376,asemeType_377,asemeComment_379 skipwhite skipempty
syntax match asemeComment_379 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_375,asemeBuiltIn_376,asemeType_377,asemeComment_379 skipwhite skipempty
syntax match asemeType_377 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeBuiltIn_376 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeClause_375 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeNumber_373 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_371,asemeComment_374 skipwhite skipempty
syntax region asemeComment_374 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_371,asemeComment_374 skipwhite skipempty
syntax match asemeComment_374 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_371,asemeComment_374 skipwhite skipempty
syntax match asemePunctuation_371 /\v\.\./ contained nextgroup=asemeNumber_370,asemeComment_372 skipwhite skipempty
syntax region asemeComment_372 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_370,asemeComment_372 skipwhite skipempty
syntax match asemeComment_372 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_370,asemeComment_372 skipwhite skipempty
syntax match asemeNumber_370 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemePunctuation_368 /\v\[/ contained nextgroup=asemeNumber_366,asemeComment_369 skipwhite skipempty
syntax region asemeComment_369 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_366,asemeComment_369 skipwhite skipempty
syntax match asemeComment_369 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_366,asemeComment_369 skipwhite skipempty
syntax match asemeNumber_366 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_365,asemeComment_367 skipwhite skipempty
syntax region asemeComment_367 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_365,asemeComment_367 skipwhite skipempty
syntax match asemeComment_367 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_365,asemeComment_367 skipwhite skipempty
syntax match asemePunctuation_365 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeClause_364 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeClause_362 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_359,asemeType_361,asemeComment_363 skipwhite skipempty
syntax region asemeComment_363 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_359,asemeType_361,asemeComment_363 skipwhite skipempty
syntax match asemeComment_363 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_359,asemeType_361,asemeComment_363 skipwhite skipempty
syntax match asemeType_361 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeBuiltIn_359 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax region asemeComment_360 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeComment_360 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_360 skipwhite skipempty
syntax match asemeDeclaration_357 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_355,asemeComment_358 skipwhite skipempty
syntax region asemeComment_358 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_355,asemeComment_358 skipwhite skipempty
syntax match asemeComment_358 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_355,asemeComment_358 skipwhite skipempty
syntax match asemeReference_355 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_353,asemeComment_356 skipwhite skipempty
syntax region asemeComment_356 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_353,asemeComment_356 skipwhite skipempty
syntax match asemeComment_356 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_353,asemeComment_356 skipwhite skipempty
syntax match asemePunctuation_353 /\v\./ contained nextgroup=asemeReference_352,asemeComment_354 skipwhite skipempty
syntax region asemeComment_354 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_352,asemeComment_354 skipwhite skipempty
syntax match asemeComment_354 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_352,asemeComment_354 skipwhite skipempty
syntax match asemeReference_352 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax cluster asemePlaysInBodyOfParticipant contains=asemeClause_295,asemeClause_299,asemeClause_329,asemeClause_331,asemePunctuation_340,asemePunctuation_343,asemeOperator_345,asemeReference_349,asemeReference_351
syntax match asemeReference_351 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeReference_349 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_347,asemeComment_350 skipwhite skipempty
syntax region asemeComment_350 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_347,asemeComment_350 skipwhite skipempty
syntax match asemeComment_350 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_347,asemeComment_350 skipwhite skipempty
syntax match asemePunctuation_347 /\v\./ contained nextgroup=asemeReference_346,asemeComment_348 skipwhite skipempty
syntax region asemeComment_348 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_346,asemeComment_348 skipwhite skipempty
syntax match asemeComment_348 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_346,asemeComment_348 skipwhite skipempty
syntax match asemeReference_346 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeOperator_345 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemePunctuation_343 /\v\./ contained nextgroup=asemeReference_342,asemeComment_344 skipwhite skipempty
syntax region asemeComment_344 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_342,asemeComment_344 skipwhite skipempty
syntax match asemeComment_344 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_342,asemeComment_344 skipwhite skipempty
syntax match asemeReference_342 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemePunctuation_340 /\v\,/ contained nextgroup=asemeReference_335,asemeReference_338,asemeComment_341 skipwhite skipempty
syntax region asemeComment_341 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_335,asemeReference_338,asemeComment_341 skipwhite skipempty
syntax match asemeComment_341 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_335,asemeReference_338,asemeComment_341 skipwhite skipempty
syntax match asemeReference_338 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_337,asemeComment_339 skipwhite skipempty
syntax region asemeComment_339 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_337,asemeComment_339 skipwhite skipempty
syntax match asemeComment_339 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_337,asemeComment_339 skipwhite skipempty
syntax match asemeOperator_337 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeReference_335 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_333,asemeComment_336 skipwhite skipempty
syntax region asemeComment_336 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_333,asemeComment_336 skipwhite skipempty
syntax match asemeComment_336 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_333,asemeComment_336 skipwhite skipempty
syntax match asemePunctuation_333 /\v\./ contained nextgroup=asemeReference_332,asemeComment_334 skipwhite skipempty
syntax region asemeComment_334 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_332,asemeComment_334 skipwhite skipempty
syntax match asemeComment_334 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_332,asemeComment_334 skipwhite skipempty
syntax match asemeReference_332 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_331 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_329 /\vwhen%(<|>)/ contained nextgroup=asemeClause_328,asemeComment_330 skipwhite skipempty
syntax region asemeComment_330 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_328,asemeComment_330 skipwhite skipempty
syntax match asemeComment_330 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_328,asemeComment_330 skipwhite skipempty
syntax match asemeClause_328 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_299 /\vas%(<|>)/ contained nextgroup=asemeReference_297,asemeComment_300 skipwhite skipempty
syntax region asemeComment_300 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_297,asemeComment_300 skipwhite skipempty
syntax match asemeComment_300 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_297,asemeComment_300 skipwhite skipempty
syntax match asemeReference_297 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax region asemeComment_298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeComment_298 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_295 /\vwith%(<|>)/ contained nextgroup=asemeReference_293,asemeComment_296 skipwhite skipempty
syntax region asemeComment_296 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_293,asemeComment_296 skipwhite skipempty
syntax match asemeComment_296 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_293,asemeComment_296 skipwhite skipempty
syntax match asemeReference_293 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_292,asemeComment_294 skipwhite skipempty
syntax region asemeComment_294 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_292,asemeComment_294 skipwhite skipempty
syntax match asemeComment_294 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_292,asemeComment_294 skipwhite skipempty
syntax match asemeOperator_292 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeDeclaration_258 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_257,asemeComment_259 skipwhite skipempty
syntax region asemeComment_259 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_257,asemeComment_259 skipwhite skipempty
syntax match asemeComment_259 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_257,asemeComment_259 skipwhite skipempty
syntax match asemeText_257 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_256 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax match asemePunctuation_254 /\v\.\./ contained nextgroup=asemeNumber_253,asemeComment_255 skipwhite skipempty
syntax region asemeComment_255 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_253,asemeComment_255 skipwhite skipempty
syntax match asemeComment_255 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_253,asemeComment_255 skipwhite skipempty
syntax match asemeNumber_253 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax match asemePunctuation_251 /\v\[/ contained nextgroup=asemeNumber_249,asemeComment_252 skipwhite skipempty
syntax region asemeComment_252 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_249,asemeComment_252 skipwhite skipempty
syntax match asemeComment_252 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_249,asemeComment_252 skipwhite skipempty
syntax match asemeNumber_249 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax region asemeComment_250 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax match asemeComment_250 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_250 skipwhite skipempty
syntax match asemeDeclaration_247 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_248 skipwhite skipempty
syntax region asemeComment_248 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_248 skipwhite skipempty
syntax match asemeComment_248 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_248 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_246
syntax region asemePunctuation_246 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_226,asemeDeclaration_244,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_244 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_243,asemeComment_245 skipwhite skipempty
syntax region asemeComment_245 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_243,asemeComment_245 skipwhite skipempty
syntax match asemeComment_245 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_243,asemeComment_245 skipwhite skipempty
syntax match asemeName_243 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_230,asemeClause_233,asemeClause_236,asemePunctuation_239,asemeText_241,asemeName_242
syntax match asemeName_242 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemeText_241 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemePunctuation_239 /\v\,/ contained nextgroup=asemeReference_238,asemeComment_240 skipwhite skipempty
syntax region asemeComment_240 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_238,asemeComment_240 skipwhite skipempty
syntax match asemeComment_240 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_238,asemeComment_240 skipwhite skipempty
syntax match asemeReference_238 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemeClause_236 /\vrealises%(<|>)/ contained nextgroup=asemeReference_235,asemeComment_237 skipwhite skipempty
syntax region asemeComment_237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_235,asemeComment_237 skipwhite skipempty
syntax match asemeComment_237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_235,asemeComment_237 skipwhite skipempty
syntax match asemeReference_235 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemeClause_233 /\vincludes%(<|>)/ contained nextgroup=asemeReference_232,asemeComment_234 skipwhite skipempty
syntax region asemeComment_234 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_232,asemeComment_234 skipwhite skipempty
syntax match asemeComment_234 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_232,asemeComment_234 skipwhite skipempty
syntax match asemeReference_232 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemeClause_230 /\vby%(<|>)/ contained nextgroup=asemeReference_228,asemeComment_231 skipwhite skipempty
syntax region asemeComment_231 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_228,asemeComment_231 skipwhite skipempty
syntax match asemeComment_231 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_228,asemeComment_231 skipwhite skipempty
syntax match asemeReference_228 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax region asemeComment_229 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemeComment_229 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_229 skipwhite skipempty
syntax match asemeDeclaration_226 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_225,asemeComment_227 skipwhite skipempty
syntax region asemeComment_227 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_225,asemeComment_227 skipwhite skipempty
syntax match asemeComment_227 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_225,asemeComment_227 skipwhite skipempty
syntax match asemeReference_225 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemeChoice_216,asemePunctuation_219,asemePunctuation_222,asemeReference_224
syntax match asemeReference_224 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax match asemePunctuation_222 /\v\:/ contained nextgroup=asemeChoice_221,asemeComment_223 skipwhite skipempty
syntax region asemeComment_223 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_221,asemeComment_223 skipwhite skipempty
syntax match asemeComment_223 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_221,asemeComment_223 skipwhite skipempty
syntax match asemeChoice_221 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax match asemePunctuation_219 /\v\,/ contained nextgroup=asemeReference_218,asemeComment_220 skipwhite skipempty
syntax region asemeComment_220 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_218,asemeComment_220 skipwhite skipempty
syntax match asemeComment_220 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_218,asemeComment_220 skipwhite skipempty
syntax match asemeReference_218 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax match asemeChoice_216 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax region asemeComment_217 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax match asemeComment_217 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_217 skipwhite skipempty
syntax match asemeDeclaration_214 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_215 skipwhite skipempty
syntax region asemeComment_215 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_215 skipwhite skipempty
syntax match asemeComment_215 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_215 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_213
syntax region asemePunctuation_213 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_211,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_211 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_210,asemeComment_212 skipwhite skipempty
syntax region asemeComment_212 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_210,asemeComment_212 skipwhite skipempty
syntax match asemeComment_212 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_210,asemeComment_212 skipwhite skipempty
syntax match asemeBlock_210 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_209 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_207,asemeBlock_208
syntax match asemeBlock_208 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_209 skipwhite skipempty
syntax region asemeComment_209 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_209 skipwhite skipempty
syntax match asemeComment_209 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_209 skipwhite skipempty
syntax region asemePunctuation_207 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_205,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_205 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_204,asemeComment_206 skipwhite skipempty
syntax region asemeComment_206 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_204,asemeComment_206 skipwhite skipempty
syntax match asemeComment_206 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_204,asemeComment_206 skipwhite skipempty
syntax match asemeName_204 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_194,asemeClause_197,asemePunctuation_200,asemeText_202,asemeName_203
syntax match asemeName_203 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax match asemeText_202 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax match asemePunctuation_200 /\v\,/ contained nextgroup=asemeReference_199,asemeComment_201 skipwhite skipempty
syntax region asemeComment_201 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_199,asemeComment_201 skipwhite skipempty
syntax match asemeComment_201 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_199,asemeComment_201 skipwhite skipempty
syntax match asemeReference_199 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax match asemeClause_197 /\von%(<|>)/ contained nextgroup=asemeReference_196,asemeComment_198 skipwhite skipempty
syntax region asemeComment_198 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_196,asemeComment_198 skipwhite skipempty
syntax match asemeComment_198 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_196,asemeComment_198 skipwhite skipempty
syntax match asemeReference_196 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax match asemeClause_194 /\vdepends%(<|>)/ contained nextgroup=asemeClause_192,asemeComment_195 skipwhite skipempty
syntax region asemeComment_195 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_192,asemeComment_195 skipwhite skipempty
syntax match asemeComment_195 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_192,asemeComment_195 skipwhite skipempty
syntax match asemeClause_192 /\von%(<|>)/ contained nextgroup=asemeReference_190,asemeComment_193 skipwhite skipempty
syntax region asemeComment_193 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_190,asemeComment_193 skipwhite skipempty
syntax match asemeComment_193 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_190,asemeComment_193 skipwhite skipempty
syntax match asemeReference_190 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax region asemeComment_191 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax match asemeComment_191 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_191 skipwhite skipempty
syntax match asemeDeclaration_188 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_186,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_186,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_186,asemeComment_189 skipwhite skipempty
syntax match asemeName_186 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_185,asemeComment_187 skipwhite skipempty
syntax region asemeComment_187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_185,asemeComment_187 skipwhite skipempty
syntax match asemeComment_187 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_185,asemeComment_187 skipwhite skipempty
syntax match asemePunctuation_185 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_158,asemePunctuation_166,asemePunctuation_172,asemeOperator_175,asemePunctuation_177,asemeBuiltIn_179,asemeType_181,asemeName_183
syntax match asemeName_183 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_182,asemeComment_184 skipwhite skipempty
syntax region asemeComment_184 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_182,asemeComment_184 skipwhite skipempty
syntax match asemeComment_184 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_182,asemeComment_184 skipwhite skipempty
syntax match asemePunctuation_182 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemeType_181 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax match asemeBuiltIn_179 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax region asemeComment_180 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax match asemeComment_180 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_178,asemeComment_180 skipwhite skipempty
syntax match asemeName_178 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemePunctuation_177 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemeOperator_175 /\v\=%(\=)@!/ contained nextgroup=asemeText_174,asemeComment_176 skipwhite skipempty
syntax region asemeComment_176 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_174,asemeComment_176 skipwhite skipempty
syntax match asemeComment_176 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_174,asemeComment_176 skipwhite skipempty
syntax match asemeText_174 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemePunctuation_172 /\v\,/ contained nextgroup=asemeBuiltIn_169,asemeType_171,asemeComment_173 skipwhite skipempty
syntax region asemeComment_173 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_169,asemeType_171,asemeComment_173 skipwhite skipempty
syntax match asemeComment_173 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_169,asemeType_171,asemeComment_173 skipwhite skipempty
syntax match asemeType_171 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_168,asemeComment_170 skipwhite skipempty
syntax match asemeBuiltIn_169 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_168,asemeComment_170 skipwhite skipempty
syntax region asemeComment_170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_168,asemeComment_170 skipwhite skipempty
syntax match asemeComment_170 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_168,asemeComment_170 skipwhite skipempty
syntax match asemeName_168 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemePunctuation_166 /\v\:/ contained nextgroup=asemeBuiltIn_163,asemeType_165,asemeComment_167 skipwhite skipempty
syntax region asemeComment_167 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_163,asemeType_165,asemeComment_167 skipwhite skipempty
syntax match asemeComment_167 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_163,asemeType_165,asemeComment_167 skipwhite skipempty
syntax match asemeType_165 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_161,asemeComment_164 skipwhite skipempty
syntax match asemeBuiltIn_163 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_161,asemeComment_164 skipwhite skipempty
syntax region asemeComment_164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_161,asemeComment_164 skipwhite skipempty
syntax match asemeComment_164 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_161,asemeComment_164 skipwhite skipempty
syntax match asemeOperator_161 /\v\=%(\=)@!/ contained nextgroup=asemeText_160,asemeComment_162 skipwhite skipempty
syntax region asemeComment_162 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_160,asemeComment_162 skipwhite skipempty
syntax match asemeComment_162 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_160,asemeComment_162 skipwhite skipempty
syntax match asemeText_160 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemePunctuation_158 /\v\)/ contained nextgroup=asemePunctuation_156,asemeComment_159 skipwhite skipempty
syntax region asemeComment_159 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_156,asemeComment_159 skipwhite skipempty
syntax match asemeComment_159 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_156,asemeComment_159 skipwhite skipempty
syntax match asemePunctuation_156 /\v\:/ contained nextgroup=asemeBuiltIn_153,asemeType_155,asemeComment_157 skipwhite skipempty
syntax region asemeComment_157 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_153,asemeType_155,asemeComment_157 skipwhite skipempty
syntax match asemeComment_157 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_153,asemeType_155,asemeComment_157 skipwhite skipempty
syntax match asemeType_155 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_151,asemeComment_154 skipwhite skipempty
syntax match asemeBuiltIn_153 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_151,asemeComment_154 skipwhite skipempty
syntax region asemeComment_154 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_151,asemeComment_154 skipwhite skipempty
syntax match asemeComment_154 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_151,asemeComment_154 skipwhite skipempty
syntax match asemeOperator_151 /\v\=%(\=)@!/ contained nextgroup=asemeText_149,asemeComment_152 skipwhite skipempty
syntax region asemeComment_152 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_149,asemeComment_152 skipwhite skipempty
syntax match asemeComment_152 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_149,asemeComment_152 skipwhite skipempty
syntax match asemeText_149 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax region asemeComment_150 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemeComment_150 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_150 skipwhite skipempty
syntax match asemeDeclaration_147 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_146,asemeComment_148 skipwhite skipempty
syntax region asemeComment_148 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_146,asemeComment_148 skipwhite skipempty
syntax match asemeComment_148 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_146,asemeComment_148 skipwhite skipempty
syntax match asemeBlock_146 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_117,asemeClause_120,asemeClause_123,asemePunctuation_144,asemeBlock_145
syntax match asemeBlock_145 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax region asemePunctuation_144 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_142,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeDeclaration_142 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_141,asemeComment_143 skipwhite skipempty
syntax region asemeComment_143 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_141,asemeComment_143 skipwhite skipempty
syntax match asemeComment_143 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_141,asemeComment_143 skipwhite skipempty
syntax match asemeReference_141 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_127,asemeClause_130,asemeClause_133,asemeChoice_135,asemePunctuation_138,asemeReference_140
syntax match asemeReference_140 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemePunctuation_138 /\v\,/ contained nextgroup=asemeReference_136,asemeReference_137,asemeComment_139 skipwhite skipempty
syntax region asemeComment_139 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_136,asemeReference_137,asemeComment_139 skipwhite skipempty
syntax match asemeComment_139 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_136,asemeReference_137,asemeComment_139 skipwhite skipempty
syntax match asemeReference_137 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeReference_136 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeChoice_135 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeClause_133 /\vexpires%(<|>)/ contained nextgroup=asemeNumber_132,asemeComment_134 skipwhite skipempty
syntax region asemeComment_134 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_132,asemeComment_134 skipwhite skipempty
syntax match asemeComment_134 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_132,asemeComment_134 skipwhite skipempty
syntax match asemeNumber_132 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeClause_130 /\vevery%(<|>)/ contained nextgroup=asemeNumber_129,asemeComment_131 skipwhite skipempty
syntax region asemeComment_131 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_129,asemeComment_131 skipwhite skipempty
syntax match asemeComment_131 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_129,asemeComment_131 skipwhite skipempty
syntax match asemeNumber_129 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeClause_127 /\vfrom%(<|>)/ contained nextgroup=asemeReference_125,asemeComment_128 skipwhite skipempty
syntax region asemeComment_128 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_125,asemeComment_128 skipwhite skipempty
syntax match asemeComment_128 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_125,asemeComment_128 skipwhite skipempty
syntax match asemeReference_125 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax region asemeComment_126 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeComment_126 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_126 skipwhite skipempty
syntax match asemeClause_123 /\vdelay%(<|>)/ contained nextgroup=asemeNumber_122,asemeComment_124 skipwhite skipempty
syntax region asemeComment_124 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_122,asemeComment_124 skipwhite skipempty
syntax match asemeComment_124 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_122,asemeComment_124 skipwhite skipempty
syntax match asemeNumber_122 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax match asemeClause_120 /\vradio%(<|>)/ contained nextgroup=asemeNumber_119,asemeComment_121 skipwhite skipempty
syntax region asemeComment_121 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_119,asemeComment_121 skipwhite skipempty
syntax match asemeComment_121 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_119,asemeComment_121 skipwhite skipempty
syntax match asemeNumber_119 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax match asemeClause_117 /\vunder%(<|>)/ contained nextgroup=asemeReference_115,asemeComment_118 skipwhite skipempty
syntax region asemeComment_118 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_115,asemeComment_118 skipwhite skipempty
syntax match asemeComment_118 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_115,asemeComment_118 skipwhite skipempty
syntax match asemeReference_115 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_116 skipwhite skipempty
syntax match asemeDeclaration_113 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_112,asemeComment_114 skipwhite skipempty
syntax region asemeComment_114 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_112,asemeComment_114 skipwhite skipempty
syntax match asemeComment_114 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_112,asemeComment_114 skipwhite skipempty
syntax match asemeBlock_112 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_111 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_109,asemeBlock_110
syntax match asemeBlock_110 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_111 skipwhite skipempty
syntax region asemeComment_111 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_111 skipwhite skipempty
syntax match asemeComment_111 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_111 skipwhite skipempty
syntax region asemePunctuation_109 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_103,asemeBuiltIn_106,asemeType_108,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeType_108 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax match asemeBuiltIn_106 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax region asemeComment_107 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax match asemeComment_107 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax match asemeName_105 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax match asemeDeclaration_103 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_100,asemeType_102,asemeComment_104 skipwhite skipempty
syntax region asemeComment_104 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_100,asemeType_102,asemeComment_104 skipwhite skipempty
syntax match asemeComment_104 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_100,asemeType_102,asemeComment_104 skipwhite skipempty
syntax match asemeType_102 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_99,asemeComment_101 skipwhite skipempty
syntax match asemeBuiltIn_100 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_99,asemeComment_101 skipwhite skipempty
syntax region asemeComment_101 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_99,asemeComment_101 skipwhite skipempty
syntax match asemeComment_101 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_99,asemeComment_101 skipwhite skipempty
syntax match asemeName_99 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_91,asemePunctuation_93,asemeBuiltIn_95,asemeType_97,asemeName_98
syntax match asemeName_98 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax match asemeType_97 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax match asemeBuiltIn_95 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax region asemeComment_96 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax match asemeComment_96 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_94,asemeComment_96 skipwhite skipempty
syntax match asemeName_94 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax match asemePunctuation_93 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax match asemeOperator_91 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_89,asemeComment_92 skipwhite skipempty
syntax region asemeComment_92 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_89,asemeComment_92 skipwhite skipempty
syntax match asemeComment_92 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_89,asemeComment_92 skipwhite skipempty
syntax match asemeNumber_89 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax region asemeComment_90 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax match asemeComment_90 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_90 skipwhite skipempty
syntax match asemeDeclaration_87 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_86,asemeComment_88 skipwhite skipempty
syntax region asemeComment_88 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_86,asemeComment_88 skipwhite skipempty
syntax match asemeComment_88 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_86,asemeComment_88 skipwhite skipempty
syntax match asemeBlock_86 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_85 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_83,asemeBlock_84
syntax match asemeBlock_84 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_85 skipwhite skipempty
syntax region asemeComment_85 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_85 skipwhite skipempty
syntax match asemeComment_85 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_85 skipwhite skipempty
syntax region asemePunctuation_83 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_82,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemeName_82 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_78 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_79,asemePunctuation_81
syntax match asemePunctuation_81 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_78 skipwhite skipempty
syntax match asemeOperator_79 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_77,asemeComment_80 skipwhite skipempty
syntax region asemeComment_80 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_77,asemeComment_80 skipwhite skipempty
syntax match asemeComment_80 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_77,asemeComment_80 skipwhite skipempty
syntax match asemeNumber_77 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_78 skipwhite skipempty
syntax region asemeComment_78 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_78 skipwhite skipempty
syntax match asemeComment_78 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_78 skipwhite skipempty
syntax match asemeDeclaration_75 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_73,asemeComment_76 skipwhite skipempty
syntax region asemeComment_76 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_73,asemeComment_76 skipwhite skipempty
syntax match asemeComment_76 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_73,asemeComment_76 skipwhite skipempty
syntax match asemeName_73 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_72,asemeComment_74 skipwhite skipempty
syntax region asemeComment_74 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_72,asemeComment_74 skipwhite skipempty
syntax match asemeComment_74 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_72,asemeComment_74 skipwhite skipempty
syntax match asemeOperator_72 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeDeclaration_12 /\v%(import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=import%(<|>)/ nextgroup=@asemeImportInFile,asemeComment_7 skipwhite skipempty
syntax cluster asemeImportInFile contains=asemeClause_8,asemeText_10,asemeReference_11
syntax match asemeReference_11 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeImportInFile,asemeComment_7 skipwhite skipempty
syntax match asemeText_10 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeImportInFile,asemeComment_7 skipwhite skipempty
syntax match asemeClause_8 /\vas%(<|>)/ contained nextgroup=asemeReference_6,asemeComment_9 skipwhite skipempty
syntax region asemeComment_9 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_6,asemeComment_9 skipwhite skipempty
syntax match asemeComment_9 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_6,asemeComment_9 skipwhite skipempty
syntax match asemeReference_6 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeImportInFile,asemeComment_7 skipwhite skipempty
syntax region asemeComment_7 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeImportInFile,asemeComment_7 skipwhite skipempty
syntax match asemeComment_7 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeImportInFile,asemeComment_7 skipwhite skipempty
syntax match asemeDeclaration_4 /\v%(system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=)@=system%(<|>)/ nextgroup=asemeName_3,asemeComment_5 skipwhite skipempty
syntax region asemeComment_5 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_3,asemeComment_5 skipwhite skipempty
syntax match asemeComment_5 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_3,asemeComment_5 skipwhite skipempty
syntax match asemeName_3 /\v%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))/ contained
syntax match asemeDeclaration_1 /\v%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=)@=language%(<|>)/ nextgroup=asemeNumber_0,asemeComment_2 skipwhite skipempty
syntax region asemeComment_2 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_0,asemeComment_2 skipwhite skipempty
syntax match asemeComment_2 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_0,asemeComment_2 skipwhite skipempty
syntax match asemeNumber_0 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_1238,asemeClause_1241,asemeText_1243,asemeNumber_1244,asemeTruth_1245,asemeLogic_1246,asemeClause_1247,asemeClause_1248,asemeClause_1249,asemeClause_1250,asemeClause_1251,asemeClause_1252,asemeClause_1253,asemeClause_1254,asemeClause_1255,asemeClause_1256,asemeClause_1257,asemeClause_1258,asemeClause_1259,asemeCall_1260,asemeReference_1261,asemeOperator_1262,asemePunctuation_1263
syntax match asemePunctuation_1263 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeOperator_1262 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeReference_1261 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeCall_1260 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1259 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1258 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1257 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1256 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1255 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1254 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1253 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1252 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1251 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1250 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1249 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1248 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1247 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeLogic_1246 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeTruth_1245 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeNumber_1244 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeText_1243 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeClause_1241 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1240,asemeComment_1242 skipwhite skipempty
syntax region asemeComment_1242 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1240,asemeComment_1242 skipwhite skipempty
syntax match asemeComment_1242 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1240,asemeComment_1242 skipwhite skipempty
syntax match asemeReference_1240 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1233,asemeComment_1235 skipwhite skipempty
syntax match asemeClause_1238 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1236,asemeComment_1239 skipwhite skipempty
syntax region asemeComment_1239 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1236,asemeComment_1239 skipwhite skipempty
syntax match asemeComment_1239 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1236,asemeComment_1239 skipwhite skipempty
syntax match asemeReference_1236 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1234,asemeComment_1237 skipwhite skipempty
syntax region asemeComment_1237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1234,asemeComment_1237 skipwhite skipempty
syntax match asemeComment_1237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1234,asemeComment_1237 skipwhite skipempty
syntax match asemeReference_1234 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1233,asemeComment_1235 skipwhite skipempty
syntax region asemeComment_1235 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1233,asemeComment_1235 skipwhite skipempty
syntax match asemeComment_1235 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1233,asemeComment_1235 skipwhite skipempty
syntax region asemePunctuation_1233 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax region asemeComment_1232 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax match asemeComment_1232 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1232 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_1186,asemeClause_1189,asemeText_1191,asemeNumber_1192,asemeTruth_1193,asemeLogic_1194,asemeClause_1195,asemeClause_1196,asemeClause_1197,asemeClause_1198,asemeClause_1199,asemeClause_1200,asemeClause_1201,asemeClause_1202,asemeClause_1203,asemeClause_1204,asemeClause_1205,asemeClause_1206,asemeClause_1207,asemeCall_1208,asemeReference_1209,asemeOperator_1210,asemePunctuation_1211
syntax match asemePunctuation_1211 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeOperator_1210 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeReference_1209 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeCall_1208 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1207 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1206 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1205 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1204 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1203 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1202 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1201 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1200 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1199 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1198 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1197 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1196 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1195 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeLogic_1194 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeTruth_1193 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeNumber_1192 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeText_1191 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1189 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1188,asemeComment_1190 skipwhite skipempty
syntax region asemeComment_1190 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1188,asemeComment_1190 skipwhite skipempty
syntax match asemeComment_1190 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1188,asemeComment_1190 skipwhite skipempty
syntax match asemeReference_1188 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1181,asemeComment_1183 skipwhite skipempty
syntax match asemeClause_1186 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1184,asemeComment_1187 skipwhite skipempty
syntax region asemeComment_1187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1184,asemeComment_1187 skipwhite skipempty
syntax match asemeComment_1187 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1184,asemeComment_1187 skipwhite skipempty
syntax match asemeReference_1184 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1182,asemeComment_1185 skipwhite skipempty
syntax region asemeComment_1185 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1182,asemeComment_1185 skipwhite skipempty
syntax match asemeComment_1185 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1182,asemeComment_1185 skipwhite skipempty
syntax match asemeReference_1182 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1181,asemeComment_1183 skipwhite skipempty
syntax region asemeComment_1183 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1181,asemeComment_1183 skipwhite skipempty
syntax match asemeComment_1183 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1181,asemeComment_1183 skipwhite skipempty
syntax region asemePunctuation_1181 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax region asemeComment_1180 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeComment_1180 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_1124,asemeClause_1127,asemeText_1129,asemeNumber_1130,asemeTruth_1131,asemeLogic_1132,asemeClause_1133,asemeClause_1134,asemeClause_1135,asemeClause_1136,asemeClause_1137,asemeClause_1138,asemeClause_1139,asemeClause_1140,asemeClause_1141,asemeClause_1142,asemeClause_1143,asemeClause_1144,asemeClause_1145,asemeCall_1146,asemeReference_1147,asemeOperator_1148,asemePunctuation_1149
syntax match asemePunctuation_1149 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeOperator_1148 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeReference_1147 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeCall_1146 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1145 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1144 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1143 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1142 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1141 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1140 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1139 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1138 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1137 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1136 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1135 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1134 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1133 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeLogic_1132 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeTruth_1131 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeNumber_1130 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeText_1129 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeClause_1127 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1126,asemeComment_1128 skipwhite skipempty
syntax region asemeComment_1128 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1126,asemeComment_1128 skipwhite skipempty
syntax match asemeComment_1128 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1126,asemeComment_1128 skipwhite skipempty
syntax match asemeReference_1126 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1119,asemeComment_1121 skipwhite skipempty
syntax match asemeClause_1124 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1122,asemeComment_1125 skipwhite skipempty
syntax region asemeComment_1125 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1122,asemeComment_1125 skipwhite skipempty
syntax match asemeComment_1125 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1122,asemeComment_1125 skipwhite skipempty
syntax match asemeReference_1122 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1120,asemeComment_1123 skipwhite skipempty
syntax region asemeComment_1123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1120,asemeComment_1123 skipwhite skipempty
syntax match asemeComment_1123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1120,asemeComment_1123 skipwhite skipempty
syntax match asemeReference_1120 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1119,asemeComment_1121 skipwhite skipempty
syntax region asemeComment_1121 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1119,asemeComment_1121 skipwhite skipempty
syntax match asemeComment_1121 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1119,asemeComment_1121 skipwhite skipempty
syntax region asemePunctuation_1119 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax region asemeComment_1118 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax match asemeComment_1118 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1118 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_915,asemeNumber_917,asemeReference_918,asemeNumber_919,asemeOperator_920,asemePunctuation_921
syntax match asemePunctuation_921 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemeOperator_920 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemeNumber_919 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemeReference_918 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemeNumber_917 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemeText_915 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax region asemeComment_916 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax match asemeComment_916 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_916 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_867,asemeClause_870,asemeText_872,asemeNumber_873,asemeTruth_874,asemeLogic_875,asemeClause_876,asemeClause_877,asemeClause_878,asemeClause_879,asemeClause_880,asemeClause_881,asemeClause_882,asemeClause_883,asemeClause_884,asemeClause_885,asemeClause_886,asemeClause_887,asemeClause_888,asemeCall_889,asemeReference_890,asemeOperator_891,asemePunctuation_892
syntax match asemePunctuation_892 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeOperator_891 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeReference_890 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeCall_889 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_888 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_887 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_886 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_885 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_884 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_883 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_882 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_881 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_880 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_879 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_878 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_877 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_876 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeLogic_875 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeTruth_874 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeNumber_873 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeText_872 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeClause_870 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_869,asemeComment_871 skipwhite skipempty
syntax region asemeComment_871 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_869,asemeComment_871 skipwhite skipempty
syntax match asemeComment_871 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_869,asemeComment_871 skipwhite skipempty
syntax match asemeReference_869 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax match asemeClause_867 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_865,asemeComment_868 skipwhite skipempty
syntax region asemeComment_868 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_865,asemeComment_868 skipwhite skipempty
syntax match asemeComment_868 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_865,asemeComment_868 skipwhite skipempty
syntax match asemeReference_865 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_863,asemeComment_866 skipwhite skipempty
syntax region asemeComment_866 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_863,asemeComment_866 skipwhite skipempty
syntax match asemeComment_866 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_863,asemeComment_866 skipwhite skipempty
syntax match asemeReference_863 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax region asemeComment_864 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax match asemeComment_864 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax region asemePunctuation_862 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax region asemeComment_861 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax match asemeComment_861 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_861 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfSrm contains=asemeReference_766,asemeText_768,asemeNumber_769,asemeTruth_770,asemeLogic_771,asemeClause_772,asemeClause_773,asemeClause_774,asemeClause_775,asemeClause_776,asemeClause_777,asemeClause_778,asemeClause_779,asemeClause_780,asemeClause_781,asemeClause_782,asemeClause_783,asemeClause_784,asemeCall_785,asemeReference_786,asemeOperator_787,asemePunctuation_788
syntax match asemePunctuation_788 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeOperator_787 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeReference_786 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeCall_785 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_784 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_783 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_782 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_781 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_780 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_779 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_778 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_777 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_776 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_775 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_774 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_773 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeClause_772 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeLogic_771 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeTruth_770 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeNumber_769 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeText_768 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeReference_766 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_764,asemeComment_767 skipwhite skipempty
syntax region asemeComment_767 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_764,asemeComment_767 skipwhite skipempty
syntax match asemeComment_767 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_764,asemeComment_767 skipwhite skipempty
syntax match asemeReference_764 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_763,asemeComment_765 skipwhite skipempty
syntax region asemeComment_765 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_763,asemeComment_765 skipwhite skipempty
syntax match asemeComment_765 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_763,asemeComment_765 skipwhite skipempty
syntax region asemePunctuation_763 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax region asemeComment_762 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax match asemeComment_762 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_762 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfSrm contains=asemeClause_727,asemeClause_730,asemeText_732,asemeNumber_733,asemeTruth_734,asemeLogic_735,asemeClause_736,asemeClause_737,asemeClause_738,asemeClause_739,asemeClause_740,asemeClause_741,asemeClause_742,asemeClause_743,asemeClause_744,asemeClause_745,asemeClause_746,asemeClause_747,asemeClause_748,asemeCall_749,asemeReference_750,asemeOperator_751,asemePunctuation_752
syntax match asemePunctuation_752 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeOperator_751 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeReference_750 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeCall_749 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_748 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_747 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_746 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_745 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_744 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_743 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_742 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_741 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_740 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_739 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_738 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_737 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_736 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeLogic_735 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeTruth_734 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeNumber_733 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeText_732 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeClause_730 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_729,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_729,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_729,asemeComment_731 skipwhite skipempty
syntax match asemeReference_729 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_722,asemeComment_724 skipwhite skipempty
syntax match asemeClause_727 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_725,asemeComment_728 skipwhite skipempty
syntax region asemeComment_728 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_725,asemeComment_728 skipwhite skipempty
syntax match asemeComment_728 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_725,asemeComment_728 skipwhite skipempty
syntax match asemeReference_725 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_723,asemeComment_726 skipwhite skipempty
syntax region asemeComment_726 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_723,asemeComment_726 skipwhite skipempty
syntax match asemeComment_726 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_723,asemeComment_726 skipwhite skipempty
syntax match asemeReference_723 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_722,asemeComment_724 skipwhite skipempty
syntax region asemeComment_724 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_722,asemeComment_724 skipwhite skipempty
syntax match asemeComment_724 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_722,asemeComment_724 skipwhite skipempty
syntax region asemePunctuation_722 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax region asemeComment_721 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax match asemeComment_721 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_721 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_654,asemeClause_657,asemeText_659,asemeNumber_660,asemeTruth_661,asemeLogic_662,asemeClause_663,asemeClause_664,asemeClause_665,asemeClause_666,asemeClause_667,asemeClause_668,asemeClause_669,asemeClause_670,asemeClause_671,asemeClause_672,asemeClause_673,asemeClause_674,asemeClause_675,asemeCall_676,asemeReference_677,asemeOperator_678,asemePunctuation_679
syntax match asemePunctuation_679 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeOperator_678 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeReference_677 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeCall_676 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_675 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_674 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_673 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_672 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_671 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_670 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_669 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_668 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_667 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_666 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_665 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_664 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_663 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeLogic_662 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeTruth_661 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeNumber_660 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeText_659 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeClause_657 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_656,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_656,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_656,asemeComment_658 skipwhite skipempty
syntax match asemeReference_656 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_649,asemeComment_651 skipwhite skipempty
syntax match asemeClause_654 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_652,asemeComment_655 skipwhite skipempty
syntax region asemeComment_655 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_652,asemeComment_655 skipwhite skipempty
syntax match asemeComment_655 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_652,asemeComment_655 skipwhite skipempty
syntax match asemeReference_652 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_650,asemeComment_653 skipwhite skipempty
syntax region asemeComment_653 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_650,asemeComment_653 skipwhite skipempty
syntax match asemeComment_653 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_650,asemeComment_653 skipwhite skipempty
syntax match asemeReference_650 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_649,asemeComment_651 skipwhite skipempty
syntax region asemeComment_651 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_649,asemeComment_651 skipwhite skipempty
syntax match asemeComment_651 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_649,asemeComment_651 skipwhite skipempty
syntax region asemePunctuation_649 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax region asemeComment_648 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax match asemeComment_648 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_648 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_614,asemeClause_617,asemeText_619,asemeNumber_620,asemeTruth_621,asemeLogic_622,asemeClause_623,asemeClause_624,asemeClause_625,asemeClause_626,asemeClause_627,asemeClause_628,asemeClause_629,asemeClause_630,asemeClause_631,asemeClause_632,asemeClause_633,asemeClause_634,asemeClause_635,asemeCall_636,asemeReference_637,asemeOperator_638,asemePunctuation_639
syntax match asemePunctuation_639 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeOperator_638 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeReference_637 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeCall_636 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_635 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_634 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_633 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_632 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_631 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_630 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_629 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_628 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_627 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_626 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_625 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_624 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_623 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeLogic_622 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeTruth_621 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeNumber_620 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeText_619 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeClause_617 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_616,asemeComment_618 skipwhite skipempty
syntax region asemeComment_618 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_616,asemeComment_618 skipwhite skipempty
syntax match asemeComment_618 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_616,asemeComment_618 skipwhite skipempty
syntax match asemeReference_616 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_609,asemeComment_611 skipwhite skipempty
syntax match asemeClause_614 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_612,asemeComment_615 skipwhite skipempty
syntax region asemeComment_615 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_612,asemeComment_615 skipwhite skipempty
syntax match asemeComment_615 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_612,asemeComment_615 skipwhite skipempty
syntax match asemeReference_612 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_610,asemeComment_613 skipwhite skipempty
syntax region asemeComment_613 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_610,asemeComment_613 skipwhite skipempty
syntax match asemeComment_613 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_610,asemeComment_613 skipwhite skipempty
syntax match asemeReference_610 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_609,asemeComment_611 skipwhite skipempty
syntax region asemeComment_611 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_609,asemeComment_611 skipwhite skipempty
syntax match asemeComment_611 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_609,asemeComment_611 skipwhite skipempty
syntax region asemePunctuation_609 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax region asemeComment_608 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax match asemeComment_608 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_608 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_543,asemeNumber_545,asemeReference_546,asemeNumber_547,asemeOperator_548,asemePunctuation_549
syntax match asemePunctuation_549 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemeOperator_548 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemeNumber_547 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemeReference_546 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemeNumber_545 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemeText_543 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_544 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant contains=asemeClause_448,asemeClause_451,asemeText_453,asemeNumber_454,asemeTruth_455,asemeLogic_456,asemeClause_457,asemeClause_458,asemeClause_459,asemeClause_460,asemeClause_461,asemeClause_462,asemeClause_463,asemeClause_464,asemeClause_465,asemeClause_466,asemeClause_467,asemeClause_468,asemeClause_469,asemeCall_470,asemeReference_471,asemeOperator_472,asemePunctuation_473
syntax match asemePunctuation_473 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeOperator_472 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeReference_471 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeCall_470 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_469 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_468 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_467 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_466 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_465 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_464 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_463 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_462 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_461 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_460 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_459 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_458 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_457 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeLogic_456 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeTruth_455 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeNumber_454 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeText_453 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeClause_451 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_450,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_450,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_450,asemeComment_452 skipwhite skipempty
syntax match asemeReference_450 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_443,asemeComment_445 skipwhite skipempty
syntax match asemeClause_448 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_446,asemeComment_449 skipwhite skipempty
syntax region asemeComment_449 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_446,asemeComment_449 skipwhite skipempty
syntax match asemeComment_449 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_446,asemeComment_449 skipwhite skipempty
syntax match asemeReference_446 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_444,asemeComment_447 skipwhite skipempty
syntax region asemeComment_447 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_444,asemeComment_447 skipwhite skipempty
syntax match asemeComment_447 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_444,asemeComment_447 skipwhite skipempty
syntax match asemeReference_444 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_443,asemeComment_445 skipwhite skipempty
syntax region asemeComment_445 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_443,asemeComment_445 skipwhite skipempty
syntax match asemeComment_445 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_443,asemeComment_445 skipwhite skipempty
syntax region asemePunctuation_443 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax region asemeComment_442 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax match asemeComment_442 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_442 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_390,asemeClause_393,asemeText_395,asemeNumber_396,asemeTruth_397,asemeLogic_398,asemeClause_399,asemeClause_400,asemeClause_401,asemeClause_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeClause_406,asemeClause_407,asemeClause_408,asemeClause_409,asemeClause_410,asemeClause_411,asemeCall_412,asemeReference_413,asemeOperator_414,asemePunctuation_415
syntax match asemePunctuation_415 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeOperator_414 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeReference_413 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeCall_412 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_411 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_410 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_409 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_408 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_407 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_406 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_402 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_401 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_400 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_399 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeLogic_398 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeTruth_397 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeNumber_396 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeText_395 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeClause_393 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_392,asemeComment_394 skipwhite skipempty
syntax region asemeComment_394 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_392,asemeComment_394 skipwhite skipempty
syntax match asemeComment_394 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_392,asemeComment_394 skipwhite skipempty
syntax match asemeReference_392 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_385,asemeComment_387 skipwhite skipempty
syntax match asemeClause_390 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_388,asemeComment_391 skipwhite skipempty
syntax region asemeComment_391 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_388,asemeComment_391 skipwhite skipempty
syntax match asemeComment_391 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_388,asemeComment_391 skipwhite skipempty
syntax match asemeReference_388 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_386,asemeComment_389 skipwhite skipempty
syntax region asemeComment_389 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_386,asemeComment_389 skipwhite skipempty
syntax match asemeComment_389 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_386,asemeComment_389 skipwhite skipempty
syntax match asemeReference_386 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_385,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_385,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_385,asemeComment_387 skipwhite skipempty
syntax region asemePunctuation_385 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax region asemeComment_384 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax match asemeComment_384 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_384 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeReference_305,asemeText_307,asemeNumber_308,asemeTruth_309,asemeLogic_310,asemeClause_311,asemeClause_312,asemeClause_313,asemeClause_314,asemeClause_315,asemeClause_316,asemeClause_317,asemeClause_318,asemeClause_319,asemeClause_320,asemeClause_321,asemeClause_322,asemeClause_323,asemeCall_324,asemeReference_325,asemeOperator_326,asemePunctuation_327
syntax match asemePunctuation_327 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeOperator_326 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeReference_325 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeCall_324 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_323 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_322 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_321 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_320 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_319 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_318 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_317 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_316 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_315 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_314 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_313 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_312 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_311 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeLogic_310 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeTruth_309 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeNumber_308 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeText_307 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeReference_305 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_303,asemeComment_306 skipwhite skipempty
syntax region asemeComment_306 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_303,asemeComment_306 skipwhite skipempty
syntax match asemeComment_306 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_303,asemeComment_306 skipwhite skipempty
syntax match asemeReference_303 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_302,asemeComment_304 skipwhite skipempty
syntax region asemeComment_304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_302,asemeComment_304 skipwhite skipempty
syntax match asemeComment_304 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_302,asemeComment_304 skipwhite skipempty
syntax region asemePunctuation_302 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeClause_266,asemeClause_269,asemeText_271,asemeNumber_272,asemeTruth_273,asemeLogic_274,asemeClause_275,asemeClause_276,asemeClause_277,asemeClause_278,asemeClause_279,asemeClause_280,asemeClause_281,asemeClause_282,asemeClause_283,asemeClause_284,asemeClause_285,asemeClause_286,asemeClause_287,asemeCall_288,asemeReference_289,asemeOperator_290,asemePunctuation_291
syntax match asemePunctuation_291 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeOperator_290 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeReference_289 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeCall_288 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_287 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_286 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_285 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_284 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_283 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_282 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_281 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_280 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_279 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_278 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_277 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_276 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_275 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeLogic_274 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeTruth_273 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeNumber_272 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeText_271 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeClause_269 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_268,asemeComment_270 skipwhite skipempty
syntax region asemeComment_270 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_268,asemeComment_270 skipwhite skipempty
syntax match asemeComment_270 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_268,asemeComment_270 skipwhite skipempty
syntax match asemeReference_268 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_261,asemeComment_263 skipwhite skipempty
syntax match asemeClause_266 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_264,asemeComment_267 skipwhite skipempty
syntax region asemeComment_267 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_264,asemeComment_267 skipwhite skipempty
syntax match asemeComment_267 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_264,asemeComment_267 skipwhite skipempty
syntax match asemeReference_264 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_262,asemeComment_265 skipwhite skipempty
syntax region asemeComment_265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_262,asemeComment_265 skipwhite skipempty
syntax match asemeComment_265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_262,asemeComment_265 skipwhite skipempty
syntax match asemeReference_262 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_261,asemeComment_263 skipwhite skipempty
syntax region asemeComment_263 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_261,asemeComment_263 skipwhite skipempty
syntax match asemeComment_263 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_261,asemeComment_263 skipwhite skipempty
syntax region asemePunctuation_261 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax region asemeComment_260 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax match asemeComment_260 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_260 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_46,asemeClause_49,asemeText_51,asemeNumber_52,asemeTruth_53,asemeLogic_54,asemeClause_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeClause_59,asemeClause_60,asemeClause_61,asemeClause_62,asemeClause_63,asemeClause_64,asemeClause_65,asemeClause_66,asemeClause_67,asemeCall_68,asemeReference_69,asemeOperator_70,asemePunctuation_71
syntax match asemePunctuation_71 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeOperator_70 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeReference_69 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeCall_68 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_67 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_66 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_65 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_64 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_63 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeLogic_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeTruth_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeNumber_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeText_51 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeClause_49 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_48,asemeComment_50 skipwhite skipempty
syntax region asemeComment_50 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_48,asemeComment_50 skipwhite skipempty
syntax match asemeComment_50 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_48,asemeComment_50 skipwhite skipempty
syntax match asemeReference_48 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_41,asemeComment_43 skipwhite skipempty
syntax match asemeClause_46 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_44,asemeComment_47 skipwhite skipempty
syntax region asemeComment_47 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_44,asemeComment_47 skipwhite skipempty
syntax match asemeComment_47 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_44,asemeComment_47 skipwhite skipempty
syntax match asemeReference_44 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_42,asemeComment_45 skipwhite skipempty
syntax region asemeComment_45 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_42,asemeComment_45 skipwhite skipempty
syntax match asemeComment_45 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_42,asemeComment_45 skipwhite skipempty
syntax match asemeReference_42 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_41,asemeComment_43 skipwhite skipempty
syntax region asemeComment_43 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_41,asemeComment_43 skipwhite skipempty
syntax match asemeComment_43 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_41,asemeComment_43 skipwhite skipempty
syntax region asemePunctuation_41 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax region asemeComment_40 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax match asemeComment_40 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_40 skipwhite skipempty
syntax cluster asemeContentOfAMessage contains=asemeText_13,asemeNumber_14,asemeTruth_15,asemeLogic_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeClause_23,asemeClause_24,asemeClause_25,asemeClause_26,asemeClause_27,asemeClause_28,asemeClause_29,asemeCall_30,asemeReference_31,asemeOperator_32,asemePunctuation_33,asemeText_34,asemeText_35,asemeNumber_36,asemeReference_37,asemeReference_38,asemePunctuation_39,asemeComment
syntax match asemePunctuation_33 /\v%([^ \t{}])@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_32 /\v%([^ \t{}])@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_31 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeCall_30 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained
syntax match asemeClause_29 /\v%([^ \t{}])@=write_messages%(<|>)%(\_s*\.)@=/ contained
syntax match asemeClause_28 /\v%([^ \t{}])@=read_messages%(<|>)%(\_s*\()@!/ contained
syntax match asemeClause_27 /\v%([^ \t{}])@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_26 /\v%([^ \t{}])@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_25 /\v%([^ \t{}])@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_24 /\v%([^ \t{}])@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained
syntax match asemeClause_23 /\v%([^ \t{}])@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_22 /\v%([^ \t{}])@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_21 /\v%([^ \t{}])@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_20 /\v%([^ \t{}])@=weight%(<|>)%(\_s+[0-9])@=/ contained
syntax match asemeClause_19 /\v%([^ \t{}])@=after%(<|>)%(\_s*\()@=/ contained
syntax match asemeClause_18 /\v%([^ \t{}])@=when%(<|>)/ contained
syntax match asemeClause_17 /\v%([^ \t{}])@=else%(<|>)/ contained
syntax match asemeLogic_16 /\v%([^ \t{}])@=%(and|or|not)%(<|>)/ contained
syntax match asemeTruth_15 /\v%([^ \t{}])@=%(true|false)%(<|>)%(\_s*\.)@!/ contained
syntax match asemeNumber_14 /\v%([^ \t{}])@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_13 /\v%([^ \t{}])@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemeComment start=/\v\/\*/ end=/\v\*\// contains=@Spell
syntax match asemeComment /\v\/\/.*$/ contains=@Spell
highlight default link asemeBlock_1053 asemeBlock
highlight default link asemeBlock_1055 asemeBlock
highlight default link asemeBlock_1067 asemeBlock
highlight default link asemeBlock_1073 asemeBlock
highlight default link asemeBlock_1078 asemeBlock
highlight default link asemeBlock_1079 asemeBlock
highlight default link asemeBlock_1084 asemeBlock
highlight default link asemeBlock_110 asemeBlock
highlight default link asemeBlock_112 asemeBlock
highlight default link asemeBlock_1227 asemeBlock
highlight default link asemeBlock_1229 asemeBlock
highlight default link asemeBlock_1297 asemeBlock
highlight default link asemeBlock_1299 asemeBlock
highlight default link asemeBlock_145 asemeBlock
highlight default link asemeBlock_146 asemeBlock
highlight default link asemeBlock_208 asemeBlock
highlight default link asemeBlock_210 asemeBlock
highlight default link asemeBlock_553 asemeBlock
highlight default link asemeBlock_554 asemeBlock
highlight default link asemeBlock_693 asemeBlock
highlight default link asemeBlock_699 asemeBlock
highlight default link asemeBlock_704 asemeBlock
highlight default link asemeBlock_706 asemeBlock
highlight default link asemeBlock_709 asemeBlock
highlight default link asemeBlock_84 asemeBlock
highlight default link asemeBlock_86 asemeBlock
highlight default link asemeBuiltIn_100 asemeBuiltIn
highlight default link asemeBuiltIn_106 asemeBuiltIn
highlight default link asemeBuiltIn_1155 asemeBuiltIn
highlight default link asemeBuiltIn_1172 asemeBuiltIn
highlight default link asemeBuiltIn_153 asemeBuiltIn
highlight default link asemeBuiltIn_163 asemeBuiltIn
highlight default link asemeBuiltIn_169 asemeBuiltIn
highlight default link asemeBuiltIn_179 asemeBuiltIn
highlight default link asemeBuiltIn_359 asemeBuiltIn
highlight default link asemeBuiltIn_376 asemeBuiltIn
highlight default link asemeBuiltIn_421 asemeBuiltIn
highlight default link asemeBuiltIn_438 asemeBuiltIn
highlight default link asemeBuiltIn_475 asemeBuiltIn
highlight default link asemeBuiltIn_481 asemeBuiltIn
highlight default link asemeBuiltIn_483 asemeBuiltIn
highlight default link asemeBuiltIn_535 asemeBuiltIn
highlight default link asemeBuiltIn_836 asemeBuiltIn
highlight default link asemeBuiltIn_853 asemeBuiltIn
highlight default link asemeBuiltIn_907 asemeBuiltIn
highlight default link asemeBuiltIn_95 asemeBuiltIn
highlight default link asemeBuiltIn_964 asemeBuiltIn
highlight default link asemeBuiltIn_972 asemeBuiltIn
highlight default link asemeBuiltIn_986 asemeBuiltIn
highlight default link asemeCall_1146 asemeCall
highlight default link asemeCall_1208 asemeCall
highlight default link asemeCall_1260 asemeCall
highlight default link asemeCall_288 asemeCall
highlight default link asemeCall_30 asemeCall
highlight default link asemeCall_324 asemeCall
highlight default link asemeCall_412 asemeCall
highlight default link asemeCall_470 asemeCall
highlight default link asemeCall_636 asemeCall
highlight default link asemeCall_676 asemeCall
highlight default link asemeCall_68 asemeCall
highlight default link asemeCall_749 asemeCall
highlight default link asemeCall_785 asemeCall
highlight default link asemeCall_889 asemeCall
highlight default link asemeChoice_1012 asemeChoice
highlight default link asemeChoice_1019 asemeChoice
highlight default link asemeChoice_1031 asemeChoice
highlight default link asemeChoice_1032 asemeChoice
highlight default link asemeChoice_1034 asemeChoice
highlight default link asemeChoice_1093 asemeChoice
highlight default link asemeChoice_1097 asemeChoice
highlight default link asemeChoice_1105 asemeChoice
highlight default link asemeChoice_135 asemeChoice
highlight default link asemeChoice_216 asemeChoice
highlight default link asemeChoice_221 asemeChoice
highlight default link asemeChoice_560 asemeChoice
highlight default link asemeChoice_567 asemeChoice
highlight default link asemeChoice_929 asemeChoice
highlight default link asemeChoice_943 asemeChoice
highlight default link asemeChoice_950 asemeChoice
highlight default link asemeChoice_962 asemeChoice
highlight default link asemeChoice_963 asemeChoice
highlight default link asemeChoice_979 asemeChoice
highlight default link asemeChoice_998 asemeChoice
highlight default link asemeClause_1001 asemeClause
highlight default link asemeClause_1004 asemeClause
highlight default link asemeClause_1007 asemeClause
highlight default link asemeClause_1010 asemeClause
highlight default link asemeClause_1013 asemeClause
highlight default link asemeClause_1016 asemeClause
highlight default link asemeClause_1022 asemeClause
highlight default link asemeClause_1025 asemeClause
highlight default link asemeClause_1028 asemeClause
highlight default link asemeClause_1030 asemeClause
highlight default link asemeClause_1080 asemeClause
highlight default link asemeClause_1089 asemeClause
highlight default link asemeClause_1124 asemeClause
highlight default link asemeClause_1127 asemeClause
highlight default link asemeClause_1133 asemeClause
highlight default link asemeClause_1134 asemeClause
highlight default link asemeClause_1135 asemeClause
highlight default link asemeClause_1136 asemeClause
highlight default link asemeClause_1137 asemeClause
highlight default link asemeClause_1138 asemeClause
highlight default link asemeClause_1139 asemeClause
highlight default link asemeClause_1140 asemeClause
highlight default link asemeClause_1141 asemeClause
highlight default link asemeClause_1142 asemeClause
highlight default link asemeClause_1143 asemeClause
highlight default link asemeClause_1144 asemeClause
highlight default link asemeClause_1145 asemeClause
highlight default link asemeClause_1158 asemeClause
highlight default link asemeClause_1160 asemeClause
highlight default link asemeClause_117 asemeClause
highlight default link asemeClause_1171 asemeClause
highlight default link asemeClause_1186 asemeClause
highlight default link asemeClause_1189 asemeClause
highlight default link asemeClause_1195 asemeClause
highlight default link asemeClause_1196 asemeClause
highlight default link asemeClause_1197 asemeClause
highlight default link asemeClause_1198 asemeClause
highlight default link asemeClause_1199 asemeClause
highlight default link asemeClause_120 asemeClause
highlight default link asemeClause_1200 asemeClause
highlight default link asemeClause_1201 asemeClause
highlight default link asemeClause_1202 asemeClause
highlight default link asemeClause_1203 asemeClause
highlight default link asemeClause_1204 asemeClause
highlight default link asemeClause_1205 asemeClause
highlight default link asemeClause_1206 asemeClause
highlight default link asemeClause_1207 asemeClause
highlight default link asemeClause_123 asemeClause
highlight default link asemeClause_1238 asemeClause
highlight default link asemeClause_1241 asemeClause
highlight default link asemeClause_1247 asemeClause
highlight default link asemeClause_1248 asemeClause
highlight default link asemeClause_1249 asemeClause
highlight default link asemeClause_1250 asemeClause
highlight default link asemeClause_1251 asemeClause
highlight default link asemeClause_1252 asemeClause
highlight default link asemeClause_1253 asemeClause
highlight default link asemeClause_1254 asemeClause
highlight default link asemeClause_1255 asemeClause
highlight default link asemeClause_1256 asemeClause
highlight default link asemeClause_1257 asemeClause
highlight default link asemeClause_1258 asemeClause
highlight default link asemeClause_1259 asemeClause
highlight default link asemeClause_1267 asemeClause
highlight default link asemeClause_127 asemeClause
highlight default link asemeClause_130 asemeClause
highlight default link asemeClause_133 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_192 asemeClause
highlight default link asemeClause_194 asemeClause
highlight default link asemeClause_197 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_230 asemeClause
highlight default link asemeClause_233 asemeClause
highlight default link asemeClause_236 asemeClause
highlight default link asemeClause_24 asemeClause
highlight default link asemeClause_25 asemeClause
highlight default link asemeClause_26 asemeClause
highlight default link asemeClause_266 asemeClause
highlight default link asemeClause_269 asemeClause
highlight default link asemeClause_27 asemeClause
highlight default link asemeClause_275 asemeClause
highlight default link asemeClause_276 asemeClause
highlight default link asemeClause_277 asemeClause
highlight default link asemeClause_278 asemeClause
highlight default link asemeClause_279 asemeClause
highlight default link asemeClause_28 asemeClause
highlight default link asemeClause_280 asemeClause
highlight default link asemeClause_281 asemeClause
highlight default link asemeClause_282 asemeClause
highlight default link asemeClause_283 asemeClause
highlight default link asemeClause_284 asemeClause
highlight default link asemeClause_285 asemeClause
highlight default link asemeClause_286 asemeClause
highlight default link asemeClause_287 asemeClause
highlight default link asemeClause_29 asemeClause
highlight default link asemeClause_295 asemeClause
highlight default link asemeClause_299 asemeClause
highlight default link asemeClause_311 asemeClause
highlight default link asemeClause_312 asemeClause
highlight default link asemeClause_313 asemeClause
highlight default link asemeClause_314 asemeClause
highlight default link asemeClause_315 asemeClause
highlight default link asemeClause_316 asemeClause
highlight default link asemeClause_317 asemeClause
highlight default link asemeClause_318 asemeClause
highlight default link asemeClause_319 asemeClause
highlight default link asemeClause_320 asemeClause
highlight default link asemeClause_321 asemeClause
highlight default link asemeClause_322 asemeClause
highlight default link asemeClause_323 asemeClause
highlight default link asemeClause_328 asemeClause
highlight default link asemeClause_329 asemeClause
highlight default link asemeClause_331 asemeClause
highlight default link asemeClause_362 asemeClause
highlight default link asemeClause_364 asemeClause
highlight default link asemeClause_375 asemeClause
highlight default link asemeClause_390 asemeClause
highlight default link asemeClause_393 asemeClause
highlight default link asemeClause_399 asemeClause
highlight default link asemeClause_400 asemeClause
highlight default link asemeClause_401 asemeClause
highlight default link asemeClause_402 asemeClause
highlight default link asemeClause_403 asemeClause
highlight default link asemeClause_404 asemeClause
highlight default link asemeClause_405 asemeClause
highlight default link asemeClause_406 asemeClause
highlight default link asemeClause_407 asemeClause
highlight default link asemeClause_408 asemeClause
highlight default link asemeClause_409 asemeClause
highlight default link asemeClause_410 asemeClause
highlight default link asemeClause_411 asemeClause
highlight default link asemeClause_448 asemeClause
highlight default link asemeClause_451 asemeClause
highlight default link asemeClause_457 asemeClause
highlight default link asemeClause_458 asemeClause
highlight default link asemeClause_459 asemeClause
highlight default link asemeClause_46 asemeClause
highlight default link asemeClause_460 asemeClause
highlight default link asemeClause_461 asemeClause
highlight default link asemeClause_462 asemeClause
highlight default link asemeClause_463 asemeClause
highlight default link asemeClause_464 asemeClause
highlight default link asemeClause_465 asemeClause
highlight default link asemeClause_466 asemeClause
highlight default link asemeClause_467 asemeClause
highlight default link asemeClause_468 asemeClause
highlight default link asemeClause_469 asemeClause
highlight default link asemeClause_49 asemeClause
highlight default link asemeClause_498 asemeClause
highlight default link asemeClause_501 asemeClause
highlight default link asemeClause_503 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_563 asemeClause
highlight default link asemeClause_565 asemeClause
highlight default link asemeClause_569 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_572 asemeClause
highlight default link asemeClause_574 asemeClause
highlight default link asemeClause_575 asemeClause
highlight default link asemeClause_578 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_580 asemeClause
highlight default link asemeClause_581 asemeClause
highlight default link asemeClause_582 asemeClause
highlight default link asemeClause_59 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_603 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_614 asemeClause
highlight default link asemeClause_617 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_623 asemeClause
highlight default link asemeClause_624 asemeClause
highlight default link asemeClause_625 asemeClause
highlight default link asemeClause_626 asemeClause
highlight default link asemeClause_627 asemeClause
highlight default link asemeClause_628 asemeClause
highlight default link asemeClause_629 asemeClause
highlight default link asemeClause_63 asemeClause
highlight default link asemeClause_630 asemeClause
highlight default link asemeClause_631 asemeClause
highlight default link asemeClause_632 asemeClause
highlight default link asemeClause_633 asemeClause
highlight default link asemeClause_634 asemeClause
highlight default link asemeClause_635 asemeClause
highlight default link asemeClause_64 asemeClause
highlight default link asemeClause_65 asemeClause
highlight default link asemeClause_654 asemeClause
highlight default link asemeClause_657 asemeClause
highlight default link asemeClause_66 asemeClause
highlight default link asemeClause_663 asemeClause
highlight default link asemeClause_664 asemeClause
highlight default link asemeClause_665 asemeClause
highlight default link asemeClause_666 asemeClause
highlight default link asemeClause_667 asemeClause
highlight default link asemeClause_668 asemeClause
highlight default link asemeClause_669 asemeClause
highlight default link asemeClause_67 asemeClause
highlight default link asemeClause_670 asemeClause
highlight default link asemeClause_671 asemeClause
highlight default link asemeClause_672 asemeClause
highlight default link asemeClause_673 asemeClause
highlight default link asemeClause_674 asemeClause
highlight default link asemeClause_675 asemeClause
highlight default link asemeClause_711 asemeClause
highlight default link asemeClause_727 asemeClause
highlight default link asemeClause_730 asemeClause
highlight default link asemeClause_736 asemeClause
highlight default link asemeClause_737 asemeClause
highlight default link asemeClause_738 asemeClause
highlight default link asemeClause_739 asemeClause
highlight default link asemeClause_740 asemeClause
highlight default link asemeClause_741 asemeClause
highlight default link asemeClause_742 asemeClause
highlight default link asemeClause_743 asemeClause
highlight default link asemeClause_744 asemeClause
highlight default link asemeClause_745 asemeClause
highlight default link asemeClause_746 asemeClause
highlight default link asemeClause_747 asemeClause
highlight default link asemeClause_748 asemeClause
highlight default link asemeClause_756 asemeClause
highlight default link asemeClause_760 asemeClause
highlight default link asemeClause_772 asemeClause
highlight default link asemeClause_773 asemeClause
highlight default link asemeClause_774 asemeClause
highlight default link asemeClause_775 asemeClause
highlight default link asemeClause_776 asemeClause
highlight default link asemeClause_777 asemeClause
highlight default link asemeClause_778 asemeClause
highlight default link asemeClause_779 asemeClause
highlight default link asemeClause_780 asemeClause
highlight default link asemeClause_781 asemeClause
highlight default link asemeClause_782 asemeClause
highlight default link asemeClause_783 asemeClause
highlight default link asemeClause_784 asemeClause
highlight default link asemeClause_789 asemeClause
highlight default link asemeClause_790 asemeClause
highlight default link asemeClause_792 asemeClause
highlight default link asemeClause_8 asemeClause
highlight default link asemeClause_839 asemeClause
highlight default link asemeClause_841 asemeClause
highlight default link asemeClause_852 asemeClause
highlight default link asemeClause_867 asemeClause
highlight default link asemeClause_870 asemeClause
highlight default link asemeClause_876 asemeClause
highlight default link asemeClause_877 asemeClause
highlight default link asemeClause_878 asemeClause
highlight default link asemeClause_879 asemeClause
highlight default link asemeClause_880 asemeClause
highlight default link asemeClause_881 asemeClause
highlight default link asemeClause_882 asemeClause
highlight default link asemeClause_883 asemeClause
highlight default link asemeClause_884 asemeClause
highlight default link asemeClause_885 asemeClause
highlight default link asemeClause_886 asemeClause
highlight default link asemeClause_887 asemeClause
highlight default link asemeClause_888 asemeClause
highlight default link asemeClause_932 asemeClause
highlight default link asemeClause_935 asemeClause
highlight default link asemeClause_938 asemeClause
highlight default link asemeClause_941 asemeClause
highlight default link asemeClause_944 asemeClause
highlight default link asemeClause_947 asemeClause
highlight default link asemeClause_953 asemeClause
highlight default link asemeClause_956 asemeClause
highlight default link asemeClause_959 asemeClause
highlight default link asemeClause_961 asemeClause
highlight default link asemeComment_1002 asemeComment
highlight default link asemeComment_1005 asemeComment
highlight default link asemeComment_1008 asemeComment
highlight default link asemeComment_101 asemeComment
highlight default link asemeComment_1011 asemeComment
highlight default link asemeComment_1014 asemeComment
highlight default link asemeComment_1017 asemeComment
highlight default link asemeComment_1020 asemeComment
highlight default link asemeComment_1023 asemeComment
highlight default link asemeComment_1026 asemeComment
highlight default link asemeComment_1029 asemeComment
highlight default link asemeComment_1035 asemeComment
highlight default link asemeComment_104 asemeComment
highlight default link asemeComment_1040 asemeComment
highlight default link asemeComment_1043 asemeComment
highlight default link asemeComment_1048 asemeComment
highlight default link asemeComment_1051 asemeComment
highlight default link asemeComment_1054 asemeComment
highlight default link asemeComment_1057 asemeComment
highlight default link asemeComment_1059 asemeComment
highlight default link asemeComment_1061 asemeComment
highlight default link asemeComment_1065 asemeComment
highlight default link asemeComment_1068 asemeComment
highlight default link asemeComment_107 asemeComment
highlight default link asemeComment_1071 asemeComment
highlight default link asemeComment_1074 asemeComment
highlight default link asemeComment_1076 asemeComment
highlight default link asemeComment_1081 asemeComment
highlight default link asemeComment_1083 asemeComment
highlight default link asemeComment_1086 asemeComment
highlight default link asemeComment_1088 asemeComment
highlight default link asemeComment_1090 asemeComment
highlight default link asemeComment_1094 asemeComment
highlight default link asemeComment_1098 asemeComment
highlight default link asemeComment_1100 asemeComment
highlight default link asemeComment_1106 asemeComment
highlight default link asemeComment_1108 asemeComment
highlight default link asemeComment_111 asemeComment
highlight default link asemeComment_1110 asemeComment
highlight default link asemeComment_1113 asemeComment
highlight default link asemeComment_1115 asemeComment
highlight default link asemeComment_1117 asemeComment
highlight default link asemeComment_1118 asemeComment
highlight default link asemeComment_1121 asemeComment
highlight default link asemeComment_1123 asemeComment
highlight default link asemeComment_1125 asemeComment
highlight default link asemeComment_1128 asemeComment
highlight default link asemeComment_114 asemeComment
highlight default link asemeComment_1152 asemeComment
highlight default link asemeComment_1154 asemeComment
highlight default link asemeComment_1156 asemeComment
highlight default link asemeComment_1159 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_1163 asemeComment
highlight default link asemeComment_1165 asemeComment
highlight default link asemeComment_1168 asemeComment
highlight default link asemeComment_1170 asemeComment
highlight default link asemeComment_1175 asemeComment
highlight default link asemeComment_1178 asemeComment
highlight default link asemeComment_118 asemeComment
highlight default link asemeComment_1180 asemeComment
highlight default link asemeComment_1183 asemeComment
highlight default link asemeComment_1185 asemeComment
highlight default link asemeComment_1187 asemeComment
highlight default link asemeComment_1190 asemeComment
highlight default link asemeComment_121 asemeComment
highlight default link asemeComment_1216 asemeComment
highlight default link asemeComment_1219 asemeComment
highlight default link asemeComment_1221 asemeComment
highlight default link asemeComment_1223 asemeComment
highlight default link asemeComment_1225 asemeComment
highlight default link asemeComment_1228 asemeComment
highlight default link asemeComment_1231 asemeComment
highlight default link asemeComment_1232 asemeComment
highlight default link asemeComment_1235 asemeComment
highlight default link asemeComment_1237 asemeComment
highlight default link asemeComment_1239 asemeComment
highlight default link asemeComment_124 asemeComment
highlight default link asemeComment_1242 asemeComment
highlight default link asemeComment_126 asemeComment
highlight default link asemeComment_1266 asemeComment
highlight default link asemeComment_1268 asemeComment
highlight default link asemeComment_1270 asemeComment
highlight default link asemeComment_1272 asemeComment
highlight default link asemeComment_1274 asemeComment
highlight default link asemeComment_1276 asemeComment
highlight default link asemeComment_1278 asemeComment
highlight default link asemeComment_128 asemeComment
highlight default link asemeComment_1281 asemeComment
highlight default link asemeComment_1283 asemeComment
highlight default link asemeComment_1286 asemeComment
highlight default link asemeComment_1289 asemeComment
highlight default link asemeComment_1292 asemeComment
highlight default link asemeComment_1298 asemeComment
highlight default link asemeComment_1301 asemeComment
highlight default link asemeComment_131 asemeComment
highlight default link asemeComment_1327 asemeComment
highlight default link asemeComment_1330 asemeComment
highlight default link asemeComment_1338 asemeComment
highlight default link asemeComment_134 asemeComment
highlight default link asemeComment_1341 asemeComment
highlight default link asemeComment_139 asemeComment
highlight default link asemeComment_143 asemeComment
highlight default link asemeComment_148 asemeComment
highlight default link asemeComment_150 asemeComment
highlight default link asemeComment_152 asemeComment
highlight default link asemeComment_154 asemeComment
highlight default link asemeComment_157 asemeComment
highlight default link asemeComment_159 asemeComment
highlight default link asemeComment_162 asemeComment
highlight default link asemeComment_164 asemeComment
highlight default link asemeComment_167 asemeComment
highlight default link asemeComment_170 asemeComment
highlight default link asemeComment_173 asemeComment
highlight default link asemeComment_176 asemeComment
highlight default link asemeComment_180 asemeComment
highlight default link asemeComment_184 asemeComment
highlight default link asemeComment_187 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_191 asemeComment
highlight default link asemeComment_193 asemeComment
highlight default link asemeComment_195 asemeComment
highlight default link asemeComment_198 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_201 asemeComment
highlight default link asemeComment_206 asemeComment
highlight default link asemeComment_209 asemeComment
highlight default link asemeComment_212 asemeComment
highlight default link asemeComment_215 asemeComment
highlight default link asemeComment_217 asemeComment
highlight default link asemeComment_220 asemeComment
highlight default link asemeComment_223 asemeComment
highlight default link asemeComment_227 asemeComment
highlight default link asemeComment_229 asemeComment
highlight default link asemeComment_231 asemeComment
highlight default link asemeComment_234 asemeComment
highlight default link asemeComment_237 asemeComment
highlight default link asemeComment_240 asemeComment
highlight default link asemeComment_245 asemeComment
highlight default link asemeComment_248 asemeComment
highlight default link asemeComment_250 asemeComment
highlight default link asemeComment_252 asemeComment
highlight default link asemeComment_255 asemeComment
highlight default link asemeComment_259 asemeComment
highlight default link asemeComment_260 asemeComment
highlight default link asemeComment_263 asemeComment
highlight default link asemeComment_265 asemeComment
highlight default link asemeComment_267 asemeComment
highlight default link asemeComment_270 asemeComment
highlight default link asemeComment_294 asemeComment
highlight default link asemeComment_296 asemeComment
highlight default link asemeComment_298 asemeComment
highlight default link asemeComment_300 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_304 asemeComment
highlight default link asemeComment_306 asemeComment
highlight default link asemeComment_330 asemeComment
highlight default link asemeComment_334 asemeComment
highlight default link asemeComment_336 asemeComment
highlight default link asemeComment_339 asemeComment
highlight default link asemeComment_341 asemeComment
highlight default link asemeComment_344 asemeComment
highlight default link asemeComment_348 asemeComment
highlight default link asemeComment_350 asemeComment
highlight default link asemeComment_354 asemeComment
highlight default link asemeComment_356 asemeComment
highlight default link asemeComment_358 asemeComment
highlight default link asemeComment_360 asemeComment
highlight default link asemeComment_363 asemeComment
highlight default link asemeComment_367 asemeComment
highlight default link asemeComment_369 asemeComment
highlight default link asemeComment_372 asemeComment
highlight default link asemeComment_374 asemeComment
highlight default link asemeComment_379 asemeComment
highlight default link asemeComment_382 asemeComment
highlight default link asemeComment_384 asemeComment
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_389 asemeComment
highlight default link asemeComment_391 asemeComment
highlight default link asemeComment_394 asemeComment
highlight default link asemeComment_40 asemeComment
highlight default link asemeComment_420 asemeComment
highlight default link asemeComment_424 asemeComment
highlight default link asemeComment_426 asemeComment
highlight default link asemeComment_428 asemeComment
highlight default link asemeComment_43 asemeComment
highlight default link asemeComment_430 asemeComment
highlight default link asemeComment_432 asemeComment
highlight default link asemeComment_434 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_441 asemeComment
highlight default link asemeComment_442 asemeComment
highlight default link asemeComment_445 asemeComment
highlight default link asemeComment_447 asemeComment
highlight default link asemeComment_449 asemeComment
highlight default link asemeComment_45 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_47 asemeComment
highlight default link asemeComment_478 asemeComment
highlight default link asemeComment_480 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_488 asemeComment
highlight default link asemeComment_490 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_495 asemeComment
highlight default link asemeComment_497 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_50 asemeComment
highlight default link asemeComment_502 asemeComment
highlight default link asemeComment_506 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_511 asemeComment
highlight default link asemeComment_514 asemeComment
highlight default link asemeComment_516 asemeComment
highlight default link asemeComment_518 asemeComment
highlight default link asemeComment_520 asemeComment
highlight default link asemeComment_522 asemeComment
highlight default link asemeComment_525 asemeComment
highlight default link asemeComment_528 asemeComment
highlight default link asemeComment_530 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_534 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_544 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_559 asemeComment
highlight default link asemeComment_561 asemeComment
highlight default link asemeComment_564 asemeComment
highlight default link asemeComment_566 asemeComment
highlight default link asemeComment_570 asemeComment
highlight default link asemeComment_573 asemeComment
highlight default link asemeComment_576 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_588 asemeComment
highlight default link asemeComment_594 asemeComment
highlight default link asemeComment_596 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_600 asemeComment
highlight default link asemeComment_602 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_608 asemeComment
highlight default link asemeComment_611 asemeComment
highlight default link asemeComment_613 asemeComment
highlight default link asemeComment_615 asemeComment
highlight default link asemeComment_618 asemeComment
highlight default link asemeComment_648 asemeComment
highlight default link asemeComment_651 asemeComment
highlight default link asemeComment_653 asemeComment
highlight default link asemeComment_655 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_682 asemeComment
highlight default link asemeComment_684 asemeComment
highlight default link asemeComment_686 asemeComment
highlight default link asemeComment_691 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_697 asemeComment
highlight default link asemeComment_7 asemeComment
highlight default link asemeComment_700 asemeComment
highlight default link asemeComment_702 asemeComment
highlight default link asemeComment_705 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_710 asemeComment
highlight default link asemeComment_712 asemeComment
highlight default link asemeComment_714 asemeComment
highlight default link asemeComment_716 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_721 asemeComment
highlight default link asemeComment_724 asemeComment
highlight default link asemeComment_726 asemeComment
highlight default link asemeComment_728 asemeComment
highlight default link asemeComment_731 asemeComment
highlight default link asemeComment_74 asemeComment
highlight default link asemeComment_755 asemeComment
highlight default link asemeComment_757 asemeComment
highlight default link asemeComment_759 asemeComment
highlight default link asemeComment_76 asemeComment
highlight default link asemeComment_761 asemeComment
highlight default link asemeComment_762 asemeComment
highlight default link asemeComment_765 asemeComment
highlight default link asemeComment_767 asemeComment
highlight default link asemeComment_78 asemeComment
highlight default link asemeComment_791 asemeComment
highlight default link asemeComment_795 asemeComment
highlight default link asemeComment_797 asemeComment
highlight default link asemeComment_80 asemeComment
highlight default link asemeComment_800 asemeComment
highlight default link asemeComment_802 asemeComment
highlight default link asemeComment_805 asemeComment
highlight default link asemeComment_809 asemeComment
highlight default link asemeComment_811 asemeComment
highlight default link asemeComment_815 asemeComment
highlight default link asemeComment_817 asemeComment
highlight default link asemeComment_819 asemeComment
highlight default link asemeComment_821 asemeComment
highlight default link asemeComment_823 asemeComment
highlight default link asemeComment_826 asemeComment
highlight default link asemeComment_830 asemeComment
highlight default link asemeComment_833 asemeComment
highlight default link asemeComment_835 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_840 asemeComment
highlight default link asemeComment_844 asemeComment
highlight default link asemeComment_846 asemeComment
highlight default link asemeComment_849 asemeComment
highlight default link asemeComment_85 asemeComment
highlight default link asemeComment_851 asemeComment
highlight default link asemeComment_856 asemeComment
highlight default link asemeComment_859 asemeComment
highlight default link asemeComment_861 asemeComment
highlight default link asemeComment_864 asemeComment
highlight default link asemeComment_866 asemeComment
highlight default link asemeComment_868 asemeComment
highlight default link asemeComment_871 asemeComment
highlight default link asemeComment_88 asemeComment
highlight default link asemeComment_897 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_90 asemeComment
highlight default link asemeComment_900 asemeComment
highlight default link asemeComment_902 asemeComment
highlight default link asemeComment_904 asemeComment
highlight default link asemeComment_906 asemeComment
highlight default link asemeComment_910 asemeComment
highlight default link asemeComment_913 asemeComment
highlight default link asemeComment_916 asemeComment
highlight default link asemeComment_92 asemeComment
highlight default link asemeComment_926 asemeComment
highlight default link asemeComment_928 asemeComment
highlight default link asemeComment_930 asemeComment
highlight default link asemeComment_933 asemeComment
highlight default link asemeComment_936 asemeComment
highlight default link asemeComment_939 asemeComment
highlight default link asemeComment_942 asemeComment
highlight default link asemeComment_945 asemeComment
highlight default link asemeComment_948 asemeComment
highlight default link asemeComment_951 asemeComment
highlight default link asemeComment_954 asemeComment
highlight default link asemeComment_957 asemeComment
highlight default link asemeComment_96 asemeComment
highlight default link asemeComment_960 asemeComment
highlight default link asemeComment_967 asemeComment
highlight default link asemeComment_969 asemeComment
highlight default link asemeComment_971 asemeComment
highlight default link asemeComment_975 asemeComment
highlight default link asemeComment_977 asemeComment
highlight default link asemeComment_980 asemeComment
highlight default link asemeComment_985 asemeComment
highlight default link asemeComment_989 asemeComment
highlight default link asemeComment_995 asemeComment
highlight default link asemeComment_997 asemeComment
highlight default link asemeComment_999 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_103 asemeDeclaration
highlight default link asemeDeclaration_1047 asemeDeclaration
highlight default link asemeDeclaration_1050 asemeDeclaration
highlight default link asemeDeclaration_1056 asemeDeclaration
highlight default link asemeDeclaration_1075 asemeDeclaration
highlight default link asemeDeclaration_1082 asemeDeclaration
highlight default link asemeDeclaration_1085 asemeDeclaration
highlight default link asemeDeclaration_1109 asemeDeclaration
highlight default link asemeDeclaration_113 asemeDeclaration
highlight default link asemeDeclaration_1153 asemeDeclaration
highlight default link asemeDeclaration_12 asemeDeclaration
highlight default link asemeDeclaration_1215 asemeDeclaration
highlight default link asemeDeclaration_1220 asemeDeclaration
highlight default link asemeDeclaration_1222 asemeDeclaration
highlight default link asemeDeclaration_1224 asemeDeclaration
highlight default link asemeDeclaration_1230 asemeDeclaration
highlight default link asemeDeclaration_1300 asemeDeclaration
highlight default link asemeDeclaration_1329 asemeDeclaration
highlight default link asemeDeclaration_1340 asemeDeclaration
highlight default link asemeDeclaration_142 asemeDeclaration
highlight default link asemeDeclaration_147 asemeDeclaration
highlight default link asemeDeclaration_188 asemeDeclaration
highlight default link asemeDeclaration_205 asemeDeclaration
highlight default link asemeDeclaration_211 asemeDeclaration
highlight default link asemeDeclaration_214 asemeDeclaration
highlight default link asemeDeclaration_226 asemeDeclaration
highlight default link asemeDeclaration_244 asemeDeclaration
highlight default link asemeDeclaration_247 asemeDeclaration
highlight default link asemeDeclaration_258 asemeDeclaration
highlight default link asemeDeclaration_357 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_419 asemeDeclaration
highlight default link asemeDeclaration_427 asemeDeclaration
highlight default link asemeDeclaration_489 asemeDeclaration
highlight default link asemeDeclaration_494 asemeDeclaration
highlight default link asemeDeclaration_515 asemeDeclaration
highlight default link asemeDeclaration_529 asemeDeclaration
highlight default link asemeDeclaration_555 asemeDeclaration
highlight default link asemeDeclaration_558 asemeDeclaration
highlight default link asemeDeclaration_591 asemeDeclaration
highlight default link asemeDeclaration_595 asemeDeclaration
highlight default link asemeDeclaration_647 asemeDeclaration
highlight default link asemeDeclaration_701 asemeDeclaration
highlight default link asemeDeclaration_707 asemeDeclaration
highlight default link asemeDeclaration_719 asemeDeclaration
highlight default link asemeDeclaration_75 asemeDeclaration
highlight default link asemeDeclaration_818 asemeDeclaration
highlight default link asemeDeclaration_834 asemeDeclaration
highlight default link asemeDeclaration_87 asemeDeclaration
highlight default link asemeDeclaration_896 asemeDeclaration
highlight default link asemeDeclaration_901 asemeDeclaration
highlight default link asemeDeclaration_925 asemeDeclaration
highlight default link asemeDeclaration_994 asemeDeclaration
highlight default link asemeLogic_1132 asemeLogic
highlight default link asemeLogic_1194 asemeLogic
highlight default link asemeLogic_1246 asemeLogic
highlight default link asemeLogic_16 asemeLogic
highlight default link asemeLogic_274 asemeLogic
highlight default link asemeLogic_310 asemeLogic
highlight default link asemeLogic_398 asemeLogic
highlight default link asemeLogic_456 asemeLogic
highlight default link asemeLogic_54 asemeLogic
highlight default link asemeLogic_622 asemeLogic
highlight default link asemeLogic_662 asemeLogic
highlight default link asemeLogic_735 asemeLogic
highlight default link asemeLogic_771 asemeLogic
highlight default link asemeLogic_875 asemeLogic
highlight default link asemeName_1045 asemeName
highlight default link asemeName_105 asemeName
highlight default link asemeName_1091 asemeName
highlight default link asemeName_1095 asemeName
highlight default link asemeName_1101 asemeName
highlight default link asemeName_1103 asemeName
highlight default link asemeName_1213 asemeName
highlight default link asemeName_1214 asemeName
highlight default link asemeName_1218 asemeName
highlight default link asemeName_1265 asemeName
highlight default link asemeName_1285 asemeName
highlight default link asemeName_1287 asemeName
highlight default link asemeName_1295 asemeName
highlight default link asemeName_168 asemeName
highlight default link asemeName_178 asemeName
highlight default link asemeName_183 asemeName
highlight default link asemeName_186 asemeName
highlight default link asemeName_203 asemeName
highlight default link asemeName_204 asemeName
highlight default link asemeName_242 asemeName
highlight default link asemeName_243 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_417 asemeName
highlight default link asemeName_418 asemeName
highlight default link asemeName_425 asemeName
highlight default link asemeName_479 asemeName
highlight default link asemeName_487 asemeName
highlight default link asemeName_492 asemeName
highlight default link asemeName_531 asemeName
highlight default link asemeName_539 asemeName
highlight default link asemeName_551 asemeName
highlight default link asemeName_571 asemeName
highlight default link asemeName_583 asemeName
highlight default link asemeName_590 asemeName
highlight default link asemeName_593 asemeName
highlight default link asemeName_73 asemeName
highlight default link asemeName_82 asemeName
highlight default link asemeName_829 asemeName
highlight default link asemeName_832 asemeName
highlight default link asemeName_894 asemeName
highlight default link asemeName_895 asemeName
highlight default link asemeName_899 asemeName
highlight default link asemeName_903 asemeName
highlight default link asemeName_911 asemeName
highlight default link asemeName_923 asemeName
highlight default link asemeName_94 asemeName
highlight default link asemeName_968 asemeName
highlight default link asemeName_976 asemeName
highlight default link asemeName_98 asemeName
highlight default link asemeName_99 asemeName
highlight default link asemeName_992 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1003 asemeNumber
highlight default link asemeNumber_1006 asemeNumber
highlight default link asemeNumber_1009 asemeNumber
highlight default link asemeNumber_1021 asemeNumber
highlight default link asemeNumber_1099 asemeNumber
highlight default link asemeNumber_1107 asemeNumber
highlight default link asemeNumber_1112 asemeNumber
highlight default link asemeNumber_1116 asemeNumber
highlight default link asemeNumber_1130 asemeNumber
highlight default link asemeNumber_1151 asemeNumber
highlight default link asemeNumber_1162 asemeNumber
highlight default link asemeNumber_1166 asemeNumber
highlight default link asemeNumber_1169 asemeNumber
highlight default link asemeNumber_1176 asemeNumber
highlight default link asemeNumber_119 asemeNumber
highlight default link asemeNumber_1192 asemeNumber
highlight default link asemeNumber_122 asemeNumber
highlight default link asemeNumber_1244 asemeNumber
highlight default link asemeNumber_1271 asemeNumber
highlight default link asemeNumber_1275 asemeNumber
highlight default link asemeNumber_1280 asemeNumber
highlight default link asemeNumber_129 asemeNumber
highlight default link asemeNumber_1303 asemeNumber
highlight default link asemeNumber_1309 asemeNumber
highlight default link asemeNumber_1315 asemeNumber
highlight default link asemeNumber_132 asemeNumber
highlight default link asemeNumber_1321 asemeNumber
highlight default link asemeNumber_1332 asemeNumber
highlight default link asemeNumber_1344 asemeNumber
highlight default link asemeNumber_14 asemeNumber
highlight default link asemeNumber_249 asemeNumber
highlight default link asemeNumber_253 asemeNumber
highlight default link asemeNumber_272 asemeNumber
highlight default link asemeNumber_308 asemeNumber
highlight default link asemeNumber_36 asemeNumber
highlight default link asemeNumber_366 asemeNumber
highlight default link asemeNumber_370 asemeNumber
highlight default link asemeNumber_373 asemeNumber
highlight default link asemeNumber_380 asemeNumber
highlight default link asemeNumber_396 asemeNumber
highlight default link asemeNumber_429 asemeNumber
highlight default link asemeNumber_433 asemeNumber
highlight default link asemeNumber_435 asemeNumber
highlight default link asemeNumber_454 asemeNumber
highlight default link asemeNumber_52 asemeNumber
highlight default link asemeNumber_545 asemeNumber
highlight default link asemeNumber_547 asemeNumber
highlight default link asemeNumber_562 asemeNumber
highlight default link asemeNumber_568 asemeNumber
highlight default link asemeNumber_577 asemeNumber
highlight default link asemeNumber_601 asemeNumber
highlight default link asemeNumber_605 asemeNumber
highlight default link asemeNumber_620 asemeNumber
highlight default link asemeNumber_642 asemeNumber
highlight default link asemeNumber_644 asemeNumber
highlight default link asemeNumber_660 asemeNumber
highlight default link asemeNumber_681 asemeNumber
highlight default link asemeNumber_685 asemeNumber
highlight default link asemeNumber_733 asemeNumber
highlight default link asemeNumber_769 asemeNumber
highlight default link asemeNumber_77 asemeNumber
highlight default link asemeNumber_843 asemeNumber
highlight default link asemeNumber_847 asemeNumber
highlight default link asemeNumber_850 asemeNumber
highlight default link asemeNumber_857 asemeNumber
highlight default link asemeNumber_873 asemeNumber
highlight default link asemeNumber_89 asemeNumber
highlight default link asemeNumber_917 asemeNumber
highlight default link asemeNumber_919 asemeNumber
highlight default link asemeNumber_934 asemeNumber
highlight default link asemeNumber_937 asemeNumber
highlight default link asemeNumber_940 asemeNumber
highlight default link asemeNumber_952 asemeNumber
highlight default link asemeOperator_1042 asemeOperator
highlight default link asemeOperator_1058 asemeOperator
highlight default link asemeOperator_1060 asemeOperator
highlight default link asemeOperator_1062 asemeOperator
highlight default link asemeOperator_1063 asemeOperator
highlight default link asemeOperator_1064 asemeOperator
highlight default link asemeOperator_1066 asemeOperator
highlight default link asemeOperator_1069 asemeOperator
highlight default link asemeOperator_1070 asemeOperator
highlight default link asemeOperator_1072 asemeOperator
highlight default link asemeOperator_1114 asemeOperator
highlight default link asemeOperator_1148 asemeOperator
highlight default link asemeOperator_1210 asemeOperator
highlight default link asemeOperator_1212 asemeOperator
highlight default link asemeOperator_1217 asemeOperator
highlight default link asemeOperator_1262 asemeOperator
highlight default link asemeOperator_1264 asemeOperator
highlight default link asemeOperator_1284 asemeOperator
highlight default link asemeOperator_1294 asemeOperator
highlight default link asemeOperator_1305 asemeOperator
highlight default link asemeOperator_1311 asemeOperator
highlight default link asemeOperator_1317 asemeOperator
highlight default link asemeOperator_1323 asemeOperator
highlight default link asemeOperator_1334 asemeOperator
highlight default link asemeOperator_151 asemeOperator
highlight default link asemeOperator_161 asemeOperator
highlight default link asemeOperator_175 asemeOperator
highlight default link asemeOperator_290 asemeOperator
highlight default link asemeOperator_292 asemeOperator
highlight default link asemeOperator_32 asemeOperator
highlight default link asemeOperator_326 asemeOperator
highlight default link asemeOperator_337 asemeOperator
highlight default link asemeOperator_345 asemeOperator
highlight default link asemeOperator_414 asemeOperator
highlight default link asemeOperator_416 asemeOperator
highlight default link asemeOperator_472 asemeOperator
highlight default link asemeOperator_474 asemeOperator
highlight default link asemeOperator_491 asemeOperator
highlight default link asemeOperator_548 asemeOperator
highlight default link asemeOperator_550 asemeOperator
highlight default link asemeOperator_587 asemeOperator
highlight default link asemeOperator_592 asemeOperator
highlight default link asemeOperator_597 asemeOperator
highlight default link asemeOperator_599 asemeOperator
highlight default link asemeOperator_606 asemeOperator
highlight default link asemeOperator_638 asemeOperator
highlight default link asemeOperator_645 asemeOperator
highlight default link asemeOperator_678 asemeOperator
highlight default link asemeOperator_683 asemeOperator
highlight default link asemeOperator_688 asemeOperator
highlight default link asemeOperator_689 asemeOperator
highlight default link asemeOperator_690 asemeOperator
highlight default link asemeOperator_692 asemeOperator
highlight default link asemeOperator_695 asemeOperator
highlight default link asemeOperator_696 asemeOperator
highlight default link asemeOperator_698 asemeOperator
highlight default link asemeOperator_70 asemeOperator
highlight default link asemeOperator_72 asemeOperator
highlight default link asemeOperator_751 asemeOperator
highlight default link asemeOperator_753 asemeOperator
highlight default link asemeOperator_787 asemeOperator
highlight default link asemeOperator_79 asemeOperator
highlight default link asemeOperator_798 asemeOperator
highlight default link asemeOperator_806 asemeOperator
highlight default link asemeOperator_822 asemeOperator
highlight default link asemeOperator_891 asemeOperator
highlight default link asemeOperator_893 asemeOperator
highlight default link asemeOperator_898 asemeOperator
highlight default link asemeOperator_91 asemeOperator
highlight default link asemeOperator_920 asemeOperator
highlight default link asemeOperator_922 asemeOperator
highlight default link asemePunctuation_1039 asemePunctuation
highlight default link asemePunctuation_1046 asemePunctuation
highlight default link asemePunctuation_1052 asemePunctuation
highlight default link asemePunctuation_1077 asemePunctuation
highlight default link asemePunctuation_109 asemePunctuation
highlight default link asemePunctuation_1111 asemePunctuation
highlight default link asemePunctuation_1119 asemePunctuation
highlight default link asemePunctuation_1149 asemePunctuation
highlight default link asemePunctuation_1150 asemePunctuation
highlight default link asemePunctuation_1161 asemePunctuation
highlight default link asemePunctuation_1164 asemePunctuation
highlight default link asemePunctuation_1167 asemePunctuation
highlight default link asemePunctuation_1174 asemePunctuation
highlight default link asemePunctuation_1177 asemePunctuation
highlight default link asemePunctuation_1179 asemePunctuation
highlight default link asemePunctuation_1181 asemePunctuation
highlight default link asemePunctuation_1211 asemePunctuation
highlight default link asemePunctuation_1226 asemePunctuation
highlight default link asemePunctuation_1233 asemePunctuation
highlight default link asemePunctuation_1263 asemePunctuation
highlight default link asemePunctuation_1269 asemePunctuation
highlight default link asemePunctuation_1273 asemePunctuation
highlight default link asemePunctuation_1277 asemePunctuation
highlight default link asemePunctuation_1279 asemePunctuation
highlight default link asemePunctuation_1282 asemePunctuation
highlight default link asemePunctuation_1288 asemePunctuation
highlight default link asemePunctuation_1291 asemePunctuation
highlight default link asemePunctuation_1293 asemePunctuation
highlight default link asemePunctuation_1296 asemePunctuation
highlight default link asemePunctuation_1306 asemePunctuation
highlight default link asemePunctuation_1307 asemePunctuation
highlight default link asemePunctuation_1312 asemePunctuation
highlight default link asemePunctuation_1313 asemePunctuation
highlight default link asemePunctuation_1318 asemePunctuation
highlight default link asemePunctuation_1319 asemePunctuation
highlight default link asemePunctuation_1324 asemePunctuation
highlight default link asemePunctuation_1325 asemePunctuation
highlight default link asemePunctuation_1335 asemePunctuation
highlight default link asemePunctuation_1336 asemePunctuation
highlight default link asemePunctuation_1347 asemePunctuation
highlight default link asemePunctuation_138 asemePunctuation
highlight default link asemePunctuation_144 asemePunctuation
highlight default link asemePunctuation_156 asemePunctuation
highlight default link asemePunctuation_158 asemePunctuation
highlight default link asemePunctuation_166 asemePunctuation
highlight default link asemePunctuation_172 asemePunctuation
highlight default link asemePunctuation_177 asemePunctuation
highlight default link asemePunctuation_182 asemePunctuation
highlight default link asemePunctuation_185 asemePunctuation
highlight default link asemePunctuation_200 asemePunctuation
highlight default link asemePunctuation_207 asemePunctuation
highlight default link asemePunctuation_213 asemePunctuation
highlight default link asemePunctuation_219 asemePunctuation
highlight default link asemePunctuation_222 asemePunctuation
highlight default link asemePunctuation_239 asemePunctuation
highlight default link asemePunctuation_246 asemePunctuation
highlight default link asemePunctuation_251 asemePunctuation
highlight default link asemePunctuation_254 asemePunctuation
highlight default link asemePunctuation_256 asemePunctuation
highlight default link asemePunctuation_261 asemePunctuation
highlight default link asemePunctuation_291 asemePunctuation
highlight default link asemePunctuation_302 asemePunctuation
highlight default link asemePunctuation_327 asemePunctuation
highlight default link asemePunctuation_33 asemePunctuation
highlight default link asemePunctuation_333 asemePunctuation
highlight default link asemePunctuation_340 asemePunctuation
highlight default link asemePunctuation_343 asemePunctuation
highlight default link asemePunctuation_347 asemePunctuation
highlight default link asemePunctuation_353 asemePunctuation
highlight default link asemePunctuation_365 asemePunctuation
highlight default link asemePunctuation_368 asemePunctuation
highlight default link asemePunctuation_371 asemePunctuation
highlight default link asemePunctuation_378 asemePunctuation
highlight default link asemePunctuation_381 asemePunctuation
highlight default link asemePunctuation_383 asemePunctuation
highlight default link asemePunctuation_385 asemePunctuation
highlight default link asemePunctuation_39 asemePunctuation
highlight default link asemePunctuation_41 asemePunctuation
highlight default link asemePunctuation_415 asemePunctuation
highlight default link asemePunctuation_423 asemePunctuation
highlight default link asemePunctuation_431 asemePunctuation
highlight default link asemePunctuation_436 asemePunctuation
highlight default link asemePunctuation_440 asemePunctuation
highlight default link asemePunctuation_443 asemePunctuation
highlight default link asemePunctuation_473 asemePunctuation
highlight default link asemePunctuation_477 asemePunctuation
highlight default link asemePunctuation_485 asemePunctuation
highlight default link asemePunctuation_507 asemePunctuation
highlight default link asemePunctuation_521 asemePunctuation
highlight default link asemePunctuation_533 asemePunctuation
highlight default link asemePunctuation_537 asemePunctuation
highlight default link asemePunctuation_540 asemePunctuation
highlight default link asemePunctuation_542 asemePunctuation
highlight default link asemePunctuation_549 asemePunctuation
highlight default link asemePunctuation_552 asemePunctuation
highlight default link asemePunctuation_584 asemePunctuation
highlight default link asemePunctuation_589 asemePunctuation
highlight default link asemePunctuation_609 asemePunctuation
highlight default link asemePunctuation_639 asemePunctuation
highlight default link asemePunctuation_640 asemePunctuation
highlight default link asemePunctuation_646 asemePunctuation
highlight default link asemePunctuation_649 asemePunctuation
highlight default link asemePunctuation_679 asemePunctuation
highlight default link asemePunctuation_680 asemePunctuation
highlight default link asemePunctuation_687 asemePunctuation
highlight default link asemePunctuation_703 asemePunctuation
highlight default link asemePunctuation_71 asemePunctuation
highlight default link asemePunctuation_715 asemePunctuation
highlight default link asemePunctuation_722 asemePunctuation
highlight default link asemePunctuation_752 asemePunctuation
highlight default link asemePunctuation_763 asemePunctuation
highlight default link asemePunctuation_788 asemePunctuation
highlight default link asemePunctuation_794 asemePunctuation
highlight default link asemePunctuation_801 asemePunctuation
highlight default link asemePunctuation_804 asemePunctuation
highlight default link asemePunctuation_808 asemePunctuation
highlight default link asemePunctuation_81 asemePunctuation
highlight default link asemePunctuation_814 asemePunctuation
highlight default link asemePunctuation_825 asemePunctuation
highlight default link asemePunctuation_83 asemePunctuation
highlight default link asemePunctuation_842 asemePunctuation
highlight default link asemePunctuation_845 asemePunctuation
highlight default link asemePunctuation_848 asemePunctuation
highlight default link asemePunctuation_855 asemePunctuation
highlight default link asemePunctuation_858 asemePunctuation
highlight default link asemePunctuation_860 asemePunctuation
highlight default link asemePunctuation_862 asemePunctuation
highlight default link asemePunctuation_892 asemePunctuation
highlight default link asemePunctuation_905 asemePunctuation
highlight default link asemePunctuation_909 asemePunctuation
highlight default link asemePunctuation_912 asemePunctuation
highlight default link asemePunctuation_914 asemePunctuation
highlight default link asemePunctuation_921 asemePunctuation
highlight default link asemePunctuation_924 asemePunctuation
highlight default link asemePunctuation_93 asemePunctuation
highlight default link asemePunctuation_966 asemePunctuation
highlight default link asemePunctuation_970 asemePunctuation
highlight default link asemePunctuation_974 asemePunctuation
highlight default link asemePunctuation_984 asemePunctuation
highlight default link asemePunctuation_988 asemePunctuation
highlight default link asemePunctuation_990 asemePunctuation
highlight default link asemePunctuation_993 asemePunctuation
highlight default link asemeReference_1000 asemeReference
highlight default link asemeReference_1015 asemeReference
highlight default link asemeReference_1018 asemeReference
highlight default link asemeReference_1024 asemeReference
highlight default link asemeReference_1027 asemeReference
highlight default link asemeReference_1033 asemeReference
highlight default link asemeReference_1036 asemeReference
highlight default link asemeReference_1037 asemeReference
highlight default link asemeReference_1038 asemeReference
highlight default link asemeReference_1044 asemeReference
highlight default link asemeReference_1087 asemeReference
highlight default link asemeReference_11 asemeReference
highlight default link asemeReference_1120 asemeReference
highlight default link asemeReference_1122 asemeReference
highlight default link asemeReference_1126 asemeReference
highlight default link asemeReference_1147 asemeReference
highlight default link asemeReference_115 asemeReference
highlight default link asemeReference_1182 asemeReference
highlight default link asemeReference_1184 asemeReference
highlight default link asemeReference_1188 asemeReference
highlight default link asemeReference_1209 asemeReference
highlight default link asemeReference_1234 asemeReference
highlight default link asemeReference_1236 asemeReference
highlight default link asemeReference_1240 asemeReference
highlight default link asemeReference_125 asemeReference
highlight default link asemeReference_1261 asemeReference
highlight default link asemeReference_1290 asemeReference
highlight default link asemeReference_1304 asemeReference
highlight default link asemeReference_1310 asemeReference
highlight default link asemeReference_1316 asemeReference
highlight default link asemeReference_1322 asemeReference
highlight default link asemeReference_1333 asemeReference
highlight default link asemeReference_1345 asemeReference
highlight default link asemeReference_1346 asemeReference
highlight default link asemeReference_136 asemeReference
highlight default link asemeReference_137 asemeReference
highlight default link asemeReference_140 asemeReference
highlight default link asemeReference_141 asemeReference
highlight default link asemeReference_190 asemeReference
highlight default link asemeReference_196 asemeReference
highlight default link asemeReference_199 asemeReference
highlight default link asemeReference_218 asemeReference
highlight default link asemeReference_224 asemeReference
highlight default link asemeReference_225 asemeReference
highlight default link asemeReference_228 asemeReference
highlight default link asemeReference_232 asemeReference
highlight default link asemeReference_235 asemeReference
highlight default link asemeReference_238 asemeReference
highlight default link asemeReference_262 asemeReference
highlight default link asemeReference_264 asemeReference
highlight default link asemeReference_268 asemeReference
highlight default link asemeReference_289 asemeReference
highlight default link asemeReference_293 asemeReference
highlight default link asemeReference_297 asemeReference
highlight default link asemeReference_303 asemeReference
highlight default link asemeReference_305 asemeReference
highlight default link asemeReference_31 asemeReference
highlight default link asemeReference_325 asemeReference
highlight default link asemeReference_332 asemeReference
highlight default link asemeReference_335 asemeReference
highlight default link asemeReference_338 asemeReference
highlight default link asemeReference_342 asemeReference
highlight default link asemeReference_346 asemeReference
highlight default link asemeReference_349 asemeReference
highlight default link asemeReference_351 asemeReference
highlight default link asemeReference_352 asemeReference
highlight default link asemeReference_355 asemeReference
highlight default link asemeReference_37 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_386 asemeReference
highlight default link asemeReference_388 asemeReference
highlight default link asemeReference_392 asemeReference
highlight default link asemeReference_413 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_44 asemeReference
highlight default link asemeReference_444 asemeReference
highlight default link asemeReference_446 asemeReference
highlight default link asemeReference_450 asemeReference
highlight default link asemeReference_471 asemeReference
highlight default link asemeReference_48 asemeReference
highlight default link asemeReference_496 asemeReference
highlight default link asemeReference_500 asemeReference
highlight default link asemeReference_504 asemeReference
highlight default link asemeReference_505 asemeReference
highlight default link asemeReference_509 asemeReference
highlight default link asemeReference_510 asemeReference
highlight default link asemeReference_512 asemeReference
highlight default link asemeReference_513 asemeReference
highlight default link asemeReference_517 asemeReference
highlight default link asemeReference_519 asemeReference
highlight default link asemeReference_523 asemeReference
highlight default link asemeReference_524 asemeReference
highlight default link asemeReference_526 asemeReference
highlight default link asemeReference_527 asemeReference
highlight default link asemeReference_546 asemeReference
highlight default link asemeReference_586 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_610 asemeReference
highlight default link asemeReference_612 asemeReference
highlight default link asemeReference_616 asemeReference
highlight default link asemeReference_637 asemeReference
highlight default link asemeReference_643 asemeReference
highlight default link asemeReference_650 asemeReference
highlight default link asemeReference_652 asemeReference
highlight default link asemeReference_656 asemeReference
highlight default link asemeReference_677 asemeReference
highlight default link asemeReference_69 asemeReference
highlight default link asemeReference_713 asemeReference
highlight default link asemeReference_717 asemeReference
highlight default link asemeReference_718 asemeReference
highlight default link asemeReference_723 asemeReference
highlight default link asemeReference_725 asemeReference
highlight default link asemeReference_729 asemeReference
highlight default link asemeReference_750 asemeReference
highlight default link asemeReference_754 asemeReference
highlight default link asemeReference_758 asemeReference
highlight default link asemeReference_764 asemeReference
highlight default link asemeReference_766 asemeReference
highlight default link asemeReference_786 asemeReference
highlight default link asemeReference_793 asemeReference
highlight default link asemeReference_796 asemeReference
highlight default link asemeReference_799 asemeReference
highlight default link asemeReference_803 asemeReference
highlight default link asemeReference_807 asemeReference
highlight default link asemeReference_810 asemeReference
highlight default link asemeReference_812 asemeReference
highlight default link asemeReference_813 asemeReference
highlight default link asemeReference_816 asemeReference
highlight default link asemeReference_820 asemeReference
highlight default link asemeReference_824 asemeReference
highlight default link asemeReference_863 asemeReference
highlight default link asemeReference_865 asemeReference
highlight default link asemeReference_869 asemeReference
highlight default link asemeReference_890 asemeReference
highlight default link asemeReference_918 asemeReference
highlight default link asemeReference_927 asemeReference
highlight default link asemeReference_931 asemeReference
highlight default link asemeReference_946 asemeReference
highlight default link asemeReference_949 asemeReference
highlight default link asemeReference_955 asemeReference
highlight default link asemeReference_958 asemeReference
highlight default link asemeReference_978 asemeReference
highlight default link asemeReference_981 asemeReference
highlight default link asemeReference_982 asemeReference
highlight default link asemeReference_983 asemeReference
highlight default link asemeReference_991 asemeReference
highlight default link asemeReference_996 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1041 asemeText
highlight default link asemeText_1049 asemeText
highlight default link asemeText_1092 asemeText
highlight default link asemeText_1096 asemeText
highlight default link asemeText_1102 asemeText
highlight default link asemeText_1104 asemeText
highlight default link asemeText_1129 asemeText
highlight default link asemeText_1191 asemeText
highlight default link asemeText_1243 asemeText
highlight default link asemeText_13 asemeText
highlight default link asemeText_1302 asemeText
highlight default link asemeText_1308 asemeText
highlight default link asemeText_1314 asemeText
highlight default link asemeText_1320 asemeText
highlight default link asemeText_1326 asemeText
highlight default link asemeText_1328 asemeText
highlight default link asemeText_1331 asemeText
highlight default link asemeText_1337 asemeText
highlight default link asemeText_1339 asemeText
highlight default link asemeText_1342 asemeText
highlight default link asemeText_1343 asemeText
highlight default link asemeText_149 asemeText
highlight default link asemeText_160 asemeText
highlight default link asemeText_174 asemeText
highlight default link asemeText_202 asemeText
highlight default link asemeText_241 asemeText
highlight default link asemeText_257 asemeText
highlight default link asemeText_271 asemeText
highlight default link asemeText_307 asemeText
highlight default link asemeText_34 asemeText
highlight default link asemeText_35 asemeText
highlight default link asemeText_395 asemeText
highlight default link asemeText_453 asemeText
highlight default link asemeText_51 asemeText
highlight default link asemeText_543 asemeText
highlight default link asemeText_557 asemeText
highlight default link asemeText_619 asemeText
highlight default link asemeText_641 asemeText
highlight default link asemeText_659 asemeText
highlight default link asemeText_732 asemeText
highlight default link asemeText_768 asemeText
highlight default link asemeText_827 asemeText
highlight default link asemeText_828 asemeText
highlight default link asemeText_831 asemeText
highlight default link asemeText_872 asemeText
highlight default link asemeText_915 asemeText
highlight default link asemeTruth_1131 asemeTruth
highlight default link asemeTruth_1193 asemeTruth
highlight default link asemeTruth_1245 asemeTruth
highlight default link asemeTruth_15 asemeTruth
highlight default link asemeTruth_273 asemeTruth
highlight default link asemeTruth_309 asemeTruth
highlight default link asemeTruth_397 asemeTruth
highlight default link asemeTruth_455 asemeTruth
highlight default link asemeTruth_53 asemeTruth
highlight default link asemeTruth_621 asemeTruth
highlight default link asemeTruth_661 asemeTruth
highlight default link asemeTruth_734 asemeTruth
highlight default link asemeTruth_770 asemeTruth
highlight default link asemeTruth_874 asemeTruth
highlight default link asemeType_102 asemeType
highlight default link asemeType_108 asemeType
highlight default link asemeType_1157 asemeType
highlight default link asemeType_1173 asemeType
highlight default link asemeType_155 asemeType
highlight default link asemeType_165 asemeType
highlight default link asemeType_171 asemeType
highlight default link asemeType_181 asemeType
highlight default link asemeType_361 asemeType
highlight default link asemeType_377 asemeType
highlight default link asemeType_422 asemeType
highlight default link asemeType_439 asemeType
highlight default link asemeType_476 asemeType
highlight default link asemeType_482 asemeType
highlight default link asemeType_484 asemeType
highlight default link asemeType_536 asemeType
highlight default link asemeType_838 asemeType
highlight default link asemeType_854 asemeType
highlight default link asemeType_908 asemeType
highlight default link asemeType_965 asemeType
highlight default link asemeType_97 asemeType
highlight default link asemeType_973 asemeType
highlight default link asemeType_987 asemeType
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
