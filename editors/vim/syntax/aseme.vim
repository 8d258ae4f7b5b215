" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1360 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1359 /\v\w+/
syntax match asemeNumber_1358 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1357 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1356 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1361 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1356,asemeText_1357,asemeNumber_1358,asemeReference_1359,asemeReference_1360,asemePunctuation_1361,asemeComment
syntax match asemeReference_39 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_38 /\v\w+/ contained
syntax match asemeNumber_37 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_36 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_35 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_40 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_12,asemeDeclaration_77,asemeDeclaration_89,asemeDeclaration_115,asemeDeclaration_149,asemeDeclaration_190,asemeDeclaration_216,asemeDeclaration_249,asemeDeclaration_715,asemeDeclaration_1093,asemeDeclaration_1096,asemeDeclaration_1243,asemeDeclaration_1314,asemeDeclaration_1343,asemeDeclaration_1354,asemeText_1356,asemeText_1357,asemeNumber_1358,asemeReference_1359,asemeReference_1360,asemePunctuation_1361,asemeComment
syntax match asemeDeclaration_1354 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1353,asemeComment_1355 skipwhite skipempty
syntax region asemeComment_1355 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1353,asemeComment_1355 skipwhite skipempty
syntax match asemeComment_1355 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1353,asemeComment_1355 skipwhite skipempty
syntax match asemeText_1353 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1352 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1350,asemeText_1351
syntax match asemeText_1351 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1352 skipwhite skipempty
syntax region asemeComment_1352 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1352 skipwhite skipempty
syntax match asemeComment_1352 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1352 skipwhite skipempty
syntax region asemePunctuation_1350 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_1333,asemeText_1345,asemeNumber_1346,asemeReference_1347,asemeOperator_1348,asemePunctuation_1349,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemePunctuation_1349 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1348 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1347 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1346 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1345 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1343 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_1342,asemeComment_1344 skipwhite skipempty
syntax region asemeComment_1344 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1342,asemeComment_1344 skipwhite skipempty
syntax match asemeComment_1344 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1342,asemeComment_1344 skipwhite skipempty
syntax match asemeText_1342 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1341 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_1339,asemeText_1340
syntax match asemeText_1340 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1341 skipwhite skipempty
syntax region asemeComment_1341 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1341 skipwhite skipempty
syntax match asemeComment_1341 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1341 skipwhite skipempty
syntax region asemePunctuation_1339 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_1333,asemeText_1334,asemeNumber_1335,asemeReference_1336,asemeOperator_1337,asemePunctuation_1338,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemePunctuation_1338 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1337 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1336 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1335 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1334 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1333 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_1327,asemeText_1328,asemeNumber_1329,asemeReference_1330,asemeOperator_1331,asemePunctuation_1332,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemePunctuation_1332 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1331 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1330 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1329 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1328 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1327 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_1321,asemeText_1322,asemeNumber_1323,asemeReference_1324,asemeOperator_1325,asemePunctuation_1326,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemePunctuation_1326 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1325 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1324 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1323 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1322 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1321 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_1316,asemeNumber_1317,asemeReference_1318,asemeOperator_1319,asemePunctuation_1320,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemePunctuation_1320 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1319 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1318 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1317 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1316 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1314 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_1313,asemeComment_1315 skipwhite skipempty
syntax region asemeComment_1315 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1313,asemeComment_1315 skipwhite skipempty
syntax match asemeComment_1315 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1313,asemeComment_1315 skipwhite skipempty
syntax match asemeBlock_1313 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1312 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_1310,asemeBlock_1311
syntax match asemeBlock_1311 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1312 skipwhite skipempty
syntax region asemeComment_1312 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1312 skipwhite skipempty
syntax match asemeComment_1312 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1312 skipwhite skipempty
syntax region asemePunctuation_1310 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_1309,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeName_1309 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_1281,asemePunctuation_1291,asemePunctuation_1296,asemePunctuation_1302,asemePunctuation_1305,asemePunctuation_1307,asemeOperator_1308
syntax match asemeOperator_1308 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemePunctuation_1307 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax match asemePunctuation_1305 /\v\:/ contained nextgroup=asemeReference_1304,asemeComment_1306 skipwhite skipempty
syntax region asemeComment_1306 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1304,asemeComment_1306 skipwhite skipempty
syntax match asemeComment_1306 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1304,asemeComment_1306 skipwhite skipempty
syntax match asemeReference_1304 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax match asemePunctuation_1302 /\v\,/ contained nextgroup=asemeName_1299,asemeName_1301,asemeComment_1303 skipwhite skipempty
syntax region asemeComment_1303 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1299,asemeName_1301,asemeComment_1303 skipwhite skipempty
syntax match asemeComment_1303 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1299,asemeName_1301,asemeComment_1303 skipwhite skipempty
syntax match asemeName_1301 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax match asemeName_1299 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1298,asemeComment_1300 skipwhite skipempty
syntax region asemeComment_1300 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1298,asemeComment_1300 skipwhite skipempty
syntax match asemeComment_1300 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1298,asemeComment_1300 skipwhite skipempty
syntax match asemeOperator_1298 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemePunctuation_1296 /\v\.\./ contained nextgroup=asemeNumber_1294,asemeComment_1297 skipwhite skipempty
syntax region asemeComment_1297 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1294,asemeComment_1297 skipwhite skipempty
syntax match asemeComment_1297 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1294,asemeComment_1297 skipwhite skipempty
syntax match asemeNumber_1294 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1293,asemeComment_1295 skipwhite skipempty
syntax region asemeComment_1295 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1293,asemeComment_1295 skipwhite skipempty
syntax match asemeComment_1295 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1293,asemeComment_1295 skipwhite skipempty
syntax match asemePunctuation_1293 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax match asemePunctuation_1291 /\v\[/ contained nextgroup=asemeNumber_1289,asemeComment_1292 skipwhite skipempty
syntax region asemeComment_1292 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1289,asemeComment_1292 skipwhite skipempty
syntax match asemeComment_1292 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1289,asemeComment_1292 skipwhite skipempty
syntax match asemeNumber_1289 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1287,asemeComment_1290 skipwhite skipempty
syntax region asemeComment_1290 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1287,asemeComment_1290 skipwhite skipempty
syntax match asemeComment_1290 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1287,asemeComment_1290 skipwhite skipempty
syntax match asemePunctuation_1287 /\v\.\./ contained nextgroup=asemeNumber_1285,asemeComment_1288 skipwhite skipempty
syntax region asemeComment_1288 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1285,asemeComment_1288 skipwhite skipempty
syntax match asemeComment_1288 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1285,asemeComment_1288 skipwhite skipempty
syntax match asemeNumber_1285 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1283,asemeComment_1286 skipwhite skipempty
syntax region asemeComment_1286 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1283,asemeComment_1286 skipwhite skipempty
syntax match asemeComment_1286 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1283,asemeComment_1286 skipwhite skipempty
syntax match asemePunctuation_1283 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax region asemeComment_1284 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax match asemeComment_1284 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1284 skipwhite skipempty
syntax match asemeClause_1281 /\vwith%(<|>)/ contained nextgroup=asemeName_1279,asemeComment_1282 skipwhite skipempty
syntax region asemeComment_1282 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1279,asemeComment_1282 skipwhite skipempty
syntax match asemeComment_1282 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1279,asemeComment_1282 skipwhite skipempty
syntax match asemeName_1279 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1278,asemeComment_1280 skipwhite skipempty
syntax region asemeComment_1280 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1278,asemeComment_1280 skipwhite skipempty
syntax match asemeComment_1280 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1278,asemeComment_1280 skipwhite skipempty
syntax match asemeOperator_1278 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeDeclaration_1243 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_1242,asemeComment_1244 skipwhite skipempty
syntax region asemeComment_1244 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1242,asemeComment_1244 skipwhite skipempty
syntax match asemeComment_1244 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1242,asemeComment_1244 skipwhite skipempty
syntax match asemeBlock_1242 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1241 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_1239,asemeBlock_1240
syntax match asemeBlock_1240 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1241 skipwhite skipempty
syntax region asemeComment_1241 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1241 skipwhite skipempty
syntax match asemeComment_1241 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1241 skipwhite skipempty
syntax region asemePunctuation_1239 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_1120,asemeNumber_1127,asemeDeclaration_1165,asemeDeclaration_1228,asemeDeclaration_1233,asemeDeclaration_1235,asemeDeclaration_1237,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_1237 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1238 skipwhite skipempty
syntax region asemeComment_1238 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1238 skipwhite skipempty
syntax match asemeComment_1238 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1238 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_1057
syntax match asemeDeclaration_1235 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1236 skipwhite skipempty
syntax region asemeComment_1236 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1236 skipwhite skipempty
syntax match asemeComment_1236 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1236 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_1004
syntax match asemeDeclaration_1233 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_1231,asemeComment_1234 skipwhite skipempty
syntax region asemeComment_1234 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1231,asemeComment_1234 skipwhite skipempty
syntax match asemeComment_1234 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1231,asemeComment_1234 skipwhite skipempty
syntax match asemeName_1231 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1230,asemeComment_1232 skipwhite skipempty
syntax region asemeComment_1232 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1230,asemeComment_1232 skipwhite skipempty
syntax match asemeComment_1232 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1230,asemeComment_1232 skipwhite skipempty
syntax match asemeOperator_1230 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeDeclaration_1228 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_1227,asemeComment_1229 skipwhite skipempty
syntax region asemeComment_1229 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1227,asemeComment_1229 skipwhite skipempty
syntax match asemeComment_1229 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1227,asemeComment_1229 skipwhite skipempty
syntax match asemeName_1227 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemeClause_1170,asemeClause_1172,asemePunctuation_1176,asemeNumber_1181,asemePunctuation_1186,asemePunctuation_1189,asemePunctuation_1191,asemeOperator_1225,asemeName_1226
syntax match asemeName_1226 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeOperator_1225 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemePunctuation_1191 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemePunctuation_1189 /\v\.\./ contained nextgroup=asemeNumber_1188,asemeComment_1190 skipwhite skipempty
syntax region asemeComment_1190 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1188,asemeComment_1190 skipwhite skipempty
syntax match asemeComment_1190 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1188,asemeComment_1190 skipwhite skipempty
syntax match asemeNumber_1188 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemePunctuation_1186 /\v\:/ contained nextgroup=asemeClause_1183,asemeBuiltIn_1184,asemeType_1185,asemeComment_1187 skipwhite skipempty
syntax region asemeComment_1187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1183,asemeBuiltIn_1184,asemeType_1185,asemeComment_1187 skipwhite skipempty
syntax match asemeComment_1187 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1183,asemeBuiltIn_1184,asemeType_1185,asemeComment_1187 skipwhite skipempty
syntax match asemeType_1185 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeBuiltIn_1184 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1183 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeNumber_1181 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1179,asemeComment_1182 skipwhite skipempty
syntax region asemeComment_1182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1179,asemeComment_1182 skipwhite skipempty
syntax match asemeComment_1182 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1179,asemeComment_1182 skipwhite skipempty
syntax match asemePunctuation_1179 /\v\.\./ contained nextgroup=asemeNumber_1178,asemeComment_1180 skipwhite skipempty
syntax region asemeComment_1180 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1178,asemeComment_1180 skipwhite skipempty
syntax match asemeComment_1180 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1178,asemeComment_1180 skipwhite skipempty
syntax match asemeNumber_1178 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemePunctuation_1176 /\v\[/ contained nextgroup=asemeNumber_1174,asemeComment_1177 skipwhite skipempty
syntax region asemeComment_1177 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1174,asemeComment_1177 skipwhite skipempty
syntax match asemeComment_1177 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1174,asemeComment_1177 skipwhite skipempty
syntax match asemeNumber_1174 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1173,asemeComment_1175 skipwhite skipempty
syntax region asemeComment_1175 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1173,asemeComment_1175 skipwhite skipempty
syntax match asemeComment_1175 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1173,asemeComment_1175 skipwhite skipempty
syntax match asemePunctuation_1173 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1172 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1170 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_1167,asemeType_1169,asemeComment_1171 skipwhite skipempty
syntax region asemeComment_1171 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1167,asemeType_1169,asemeComment_1171 skipwhite skipempty
syntax match asemeComment_1171 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1167,asemeType_1169,asemeComment_1171 skipwhite skipempty
syntax match asemeType_1169 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeBuiltIn_1167 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax region asemeComment_1168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeComment_1168 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeDeclaration_1165 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_1163,asemeComment_1166 skipwhite skipempty
syntax region asemeComment_1166 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1163,asemeComment_1166 skipwhite skipempty
syntax match asemeComment_1166 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1163,asemeComment_1166 skipwhite skipempty
syntax match asemeNumber_1163 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1162,asemeComment_1164 skipwhite skipempty
syntax region asemeComment_1164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1162,asemeComment_1164 skipwhite skipempty
syntax match asemeComment_1164 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1162,asemeComment_1164 skipwhite skipempty
syntax match asemePunctuation_1162 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeNumber_1127 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_1125,asemeComment_1128 skipwhite skipempty
syntax region asemeComment_1128 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1125,asemeComment_1128 skipwhite skipempty
syntax match asemeComment_1128 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1125,asemeComment_1128 skipwhite skipempty
syntax match asemeOperator_1125 /\v\-\>/ contained nextgroup=asemeNumber_1123,asemeComment_1126 skipwhite skipempty
syntax region asemeComment_1126 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1123,asemeComment_1126 skipwhite skipempty
syntax match asemeComment_1126 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1123,asemeComment_1126 skipwhite skipempty
syntax match asemeNumber_1123 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1122,asemeComment_1124 skipwhite skipempty
syntax region asemeComment_1124 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1122,asemeComment_1124 skipwhite skipempty
syntax match asemeComment_1124 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1122,asemeComment_1124 skipwhite skipempty
syntax match asemePunctuation_1122 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeDeclaration_1120 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_1118,asemeComment_1121 skipwhite skipempty
syntax region asemeComment_1121 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1118,asemeComment_1121 skipwhite skipempty
syntax match asemeComment_1121 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1118,asemeComment_1121 skipwhite skipempty
syntax match asemeNumber_1118 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1116,asemeComment_1119 skipwhite skipempty
syntax region asemeComment_1119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1116,asemeComment_1119 skipwhite skipempty
syntax match asemeComment_1119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1116,asemeComment_1119 skipwhite skipempty
syntax match asemeChoice_1116 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1114,asemeText_1115,@asemeChartNodeInBodyOfStatechart,asemeComment_1117 skipwhite skipempty
syntax region asemeComment_1117 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1114,asemeText_1115,@asemeChartNodeInBodyOfStatechart,asemeComment_1117 skipwhite skipempty
syntax match asemeComment_1117 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1114,asemeText_1115,@asemeChartNodeInBodyOfStatechart,asemeComment_1117 skipwhite skipempty
syntax match asemeText_1115 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeName_1114 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_1100,asemeChoice_1104,asemeNumber_1110,asemeName_1112,asemeText_1113
syntax match asemeText_1113 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeName_1112 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeNumber_1110 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1108,asemeComment_1111 skipwhite skipempty
syntax region asemeComment_1111 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1108,asemeComment_1111 skipwhite skipempty
syntax match asemeComment_1111 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1108,asemeComment_1111 skipwhite skipempty
syntax match asemeChoice_1108 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1106,asemeText_1107,@asemeChartNodeInBodyOfStatechart,asemeComment_1109 skipwhite skipempty
syntax region asemeComment_1109 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1106,asemeText_1107,@asemeChartNodeInBodyOfStatechart,asemeComment_1109 skipwhite skipempty
syntax match asemeComment_1109 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1106,asemeText_1107,@asemeChartNodeInBodyOfStatechart,asemeComment_1109 skipwhite skipempty
syntax match asemeText_1107 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeName_1106 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeChoice_1104 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1102,asemeText_1103,@asemeChartNodeInBodyOfStatechart,asemeComment_1105 skipwhite skipempty
syntax region asemeComment_1105 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1102,asemeText_1103,@asemeChartNodeInBodyOfStatechart,asemeComment_1105 skipwhite skipempty
syntax match asemeComment_1105 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1102,asemeText_1103,@asemeChartNodeInBodyOfStatechart,asemeComment_1105 skipwhite skipempty
syntax match asemeText_1103 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeName_1102 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeClause_1100 /\vactivity%(<|>)/ contained nextgroup=asemeReference_1098,asemeComment_1101 skipwhite skipempty
syntax region asemeComment_1101 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1098,asemeComment_1101 skipwhite skipempty
syntax match asemeComment_1101 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1098,asemeComment_1101 skipwhite skipempty
syntax match asemeReference_1098 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax region asemeComment_1099 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeComment_1099 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1099 skipwhite skipempty
syntax match asemeDeclaration_1096 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_1095,asemeComment_1097 skipwhite skipempty
syntax region asemeComment_1097 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1095,asemeComment_1097 skipwhite skipempty
syntax match asemeComment_1097 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1095,asemeComment_1097 skipwhite skipempty
syntax match asemeBlock_1095 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_718 skipwhite skipempty
syntax match asemeDeclaration_1093 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_1091,asemeComment_1094 skipwhite skipempty
syntax region asemeComment_1094 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1091,asemeComment_1094 skipwhite skipempty
syntax match asemeComment_1094 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1091,asemeComment_1094 skipwhite skipempty
syntax match asemeClause_1091 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_1090,asemeComment_1092 skipwhite skipempty
syntax region asemeComment_1092 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1090,asemeComment_1092 skipwhite skipempty
syntax match asemeComment_1092 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1090,asemeComment_1092 skipwhite skipempty
syntax match asemeBlock_1090 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_718 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_719,asemePunctuation_1088,asemeBlock_1089
syntax match asemeBlock_1089 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_718 skipwhite skipempty
syntax region asemePunctuation_1088 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_727,asemeDeclaration_828,asemeDeclaration_844,asemeDeclaration_907,asemeDeclaration_912,asemeDeclaration_936,asemeDeclaration_1005,asemeDeclaration_1058,asemeDeclaration_1067,asemeDeclaration_1086,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_1086 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_1084,asemeComment_1087 skipwhite skipempty
syntax region asemeComment_1087 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1084,asemeComment_1087 skipwhite skipempty
syntax match asemeComment_1087 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1084,asemeComment_1087 skipwhite skipempty
syntax match asemeBlock_1084 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1081,asemeOperator_1083,@asemeControlInBodyOfSrm,asemeComment_1085 skipwhite skipempty
syntax region asemeComment_1085 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1081,asemeOperator_1083,@asemeControlInBodyOfSrm,asemeComment_1085 skipwhite skipempty
syntax match asemeComment_1085 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1081,asemeOperator_1083,@asemeControlInBodyOfSrm,asemeComment_1085 skipwhite skipempty
syntax match asemeOperator_1083 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeOperator_1081 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1080,@asemeControlInBodyOfSrm,asemeComment_1082 skipwhite skipempty
syntax region asemeComment_1082 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1080,@asemeControlInBodyOfSrm,asemeComment_1082 skipwhite skipempty
syntax match asemeComment_1082 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1080,@asemeControlInBodyOfSrm,asemeComment_1082 skipwhite skipempty
syntax match asemeOperator_1080 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemeOperator_1071,asemePunctuation_695,asemeOperator_1073,asemeBlock_1078
syntax match asemeBlock_1078 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1075,asemeOperator_1077,@asemeControlInBodyOfSrm,asemeComment_1079 skipwhite skipempty
syntax region asemeComment_1079 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1075,asemeOperator_1077,@asemeControlInBodyOfSrm,asemeComment_1079 skipwhite skipempty
syntax match asemeComment_1079 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1075,asemeOperator_1077,@asemeControlInBodyOfSrm,asemeComment_1079 skipwhite skipempty
syntax match asemeOperator_1077 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeOperator_1075 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1074,@asemeControlInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax region asemeComment_1076 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1074,@asemeControlInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax match asemeComment_1076 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1074,@asemeControlInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax match asemeOperator_1074 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeOperator_1073 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeOperator_1071 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1069,@asemeControlInBodyOfSrm,asemeComment_1072 skipwhite skipempty
syntax region asemeComment_1072 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1069,@asemeControlInBodyOfSrm,asemeComment_1072 skipwhite skipempty
syntax match asemeComment_1072 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1069,@asemeControlInBodyOfSrm,asemeComment_1072 skipwhite skipempty
syntax match asemeOperator_1069 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax region asemeComment_1070 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeComment_1070 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeDeclaration_1067 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_1066,asemeComment_1068 skipwhite skipempty
syntax region asemeComment_1068 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1066,asemeComment_1068 skipwhite skipempty
syntax match asemeComment_1068 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1066,asemeComment_1068 skipwhite skipempty
syntax match asemeBlock_1066 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_1063,asemeBlock_1064
syntax match asemeBlock_1064 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax region asemeComment_1065 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax match asemeComment_1065 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1065 skipwhite skipempty
syntax region asemePunctuation_1063 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_1061,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_1061 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_1060,asemeComment_1062 skipwhite skipempty
syntax region asemeComment_1062 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1060,asemeComment_1062 skipwhite skipempty
syntax match asemeComment_1062 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1060,asemeComment_1062 skipwhite skipempty
syntax match asemeText_1060 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1058 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax region asemeComment_1059 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax match asemeComment_1059 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1059 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_1057
syntax region asemePunctuation_1057 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_1056,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeName_1056 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_1012,asemeClause_1015,asemeClause_1018,asemeClause_1021,asemeClause_1024,asemeClause_1027,asemeChoice_1030,asemeClause_1033,asemeClause_1036,asemeClause_1039,asemeClause_1041,asemeChoice_1042,asemeChoice_1043,asemePunctuation_1050,asemeOperator_1053,asemeReference_1055
syntax match asemeReference_1055 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeOperator_1053 /\v\=%(\=)@!/ contained nextgroup=asemeText_1052,asemeComment_1054 skipwhite skipempty
syntax region asemeComment_1054 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1052,asemeComment_1054 skipwhite skipempty
syntax match asemeComment_1054 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1052,asemeComment_1054 skipwhite skipempty
syntax match asemeText_1052 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemePunctuation_1050 /\v\,/ contained nextgroup=asemeChoice_1045,asemeReference_1047,asemeReference_1048,asemeReference_1049,asemeComment_1051 skipwhite skipempty
syntax region asemeComment_1051 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1045,asemeReference_1047,asemeReference_1048,asemeReference_1049,asemeComment_1051 skipwhite skipempty
syntax match asemeComment_1051 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1045,asemeReference_1047,asemeReference_1048,asemeReference_1049,asemeComment_1051 skipwhite skipempty
syntax match asemeReference_1049 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeReference_1048 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeReference_1047 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeChoice_1045 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1044,asemeComment_1046 skipwhite skipempty
syntax region asemeComment_1046 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1044,asemeComment_1046 skipwhite skipempty
syntax match asemeComment_1046 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1044,asemeComment_1046 skipwhite skipempty
syntax match asemeReference_1044 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeChoice_1043 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeChoice_1042 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1041 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1039 /\vends%(<|>)/ contained nextgroup=asemeReference_1038,asemeComment_1040 skipwhite skipempty
syntax region asemeComment_1040 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1038,asemeComment_1040 skipwhite skipempty
syntax match asemeComment_1040 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1038,asemeComment_1040 skipwhite skipempty
syntax match asemeReference_1038 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1036 /\vwrites%(<|>)/ contained nextgroup=asemeReference_1035,asemeComment_1037 skipwhite skipempty
syntax region asemeComment_1037 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1035,asemeComment_1037 skipwhite skipempty
syntax match asemeComment_1037 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1035,asemeComment_1037 skipwhite skipempty
syntax match asemeReference_1035 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1033 /\vfor%(<|>)/ contained nextgroup=asemeNumber_1032,asemeComment_1034 skipwhite skipempty
syntax region asemeComment_1034 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1032,asemeComment_1034 skipwhite skipempty
syntax match asemeComment_1034 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1032,asemeComment_1034 skipwhite skipempty
syntax match asemeNumber_1032 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeChoice_1030 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1029,asemeComment_1031 skipwhite skipempty
syntax region asemeComment_1031 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1029,asemeComment_1031 skipwhite skipempty
syntax match asemeComment_1031 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1029,asemeComment_1031 skipwhite skipempty
syntax match asemeReference_1029 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1027 /\vuses%(<|>)/ contained nextgroup=asemeReference_1026,asemeComment_1028 skipwhite skipempty
syntax region asemeComment_1028 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1026,asemeComment_1028 skipwhite skipempty
syntax match asemeComment_1028 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1026,asemeComment_1028 skipwhite skipempty
syntax match asemeReference_1026 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1024 /\vas%(<|>)/ contained nextgroup=asemeChoice_1023,asemeComment_1025 skipwhite skipempty
syntax region asemeComment_1025 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1023,asemeComment_1025 skipwhite skipempty
syntax match asemeComment_1025 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1023,asemeComment_1025 skipwhite skipempty
syntax match asemeChoice_1023 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1021 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_1020,asemeComment_1022 skipwhite skipempty
syntax region asemeComment_1022 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1020,asemeComment_1022 skipwhite skipempty
syntax match asemeComment_1022 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1020,asemeComment_1022 skipwhite skipempty
syntax match asemeNumber_1020 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1018 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_1017,asemeComment_1019 skipwhite skipempty
syntax region asemeComment_1019 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1017,asemeComment_1019 skipwhite skipempty
syntax match asemeComment_1019 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1017,asemeComment_1019 skipwhite skipempty
syntax match asemeNumber_1017 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1015 /\vevery%(<|>)/ contained nextgroup=asemeNumber_1014,asemeComment_1016 skipwhite skipempty
syntax region asemeComment_1016 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1014,asemeComment_1016 skipwhite skipempty
syntax match asemeComment_1016 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1014,asemeComment_1016 skipwhite skipempty
syntax match asemeNumber_1014 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeClause_1012 /\vreads%(<|>)/ contained nextgroup=asemeChoice_1009,asemeReference_1011,asemeComment_1013 skipwhite skipempty
syntax region asemeComment_1013 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1009,asemeReference_1011,asemeComment_1013 skipwhite skipempty
syntax match asemeComment_1013 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1009,asemeReference_1011,asemeComment_1013 skipwhite skipempty
syntax match asemeReference_1011 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeChoice_1009 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1007,asemeComment_1010 skipwhite skipempty
syntax region asemeComment_1010 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1007,asemeComment_1010 skipwhite skipempty
syntax match asemeComment_1010 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1007,asemeComment_1010 skipwhite skipempty
syntax match asemeReference_1007 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax region asemeComment_1008 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeComment_1008 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_1008 skipwhite skipempty
syntax match asemeDeclaration_1005 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax region asemeComment_1006 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax match asemeComment_1006 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_1004
syntax region asemePunctuation_1004 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_1003,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeName_1003 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_943,asemeClause_946,asemeClause_949,asemeClause_952,asemeClause_955,asemeClause_958,asemeChoice_961,asemeClause_964,asemeClause_967,asemeClause_970,asemeClause_972,asemeChoice_973,asemeChoice_974,asemePunctuation_981,asemePunctuation_995,asemePunctuation_999,asemePunctuation_1001,asemeReference_1002
syntax match asemeReference_1002 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemePunctuation_1001 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemePunctuation_999 /\v\:/ contained nextgroup=asemeBuiltIn_997,asemeType_998,asemeComment_1000 skipwhite skipempty
syntax region asemeComment_1000 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_997,asemeType_998,asemeComment_1000 skipwhite skipempty
syntax match asemeComment_1000 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_997,asemeType_998,asemeComment_1000 skipwhite skipempty
syntax match asemeType_998 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeBuiltIn_997 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemePunctuation_995 /\v\,/ contained nextgroup=asemeName_987,asemeChoice_990,asemeReference_992,asemeReference_993,asemeReference_994,asemeComment_996 skipwhite skipempty
syntax region asemeComment_996 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_987,asemeChoice_990,asemeReference_992,asemeReference_993,asemeReference_994,asemeComment_996 skipwhite skipempty
syntax match asemeComment_996 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_987,asemeChoice_990,asemeReference_992,asemeReference_993,asemeReference_994,asemeComment_996 skipwhite skipempty
syntax match asemeReference_994 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeReference_993 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeReference_992 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeChoice_990 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_989,asemeComment_991 skipwhite skipempty
syntax region asemeComment_991 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_989,asemeComment_991 skipwhite skipempty
syntax match asemeComment_991 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_989,asemeComment_991 skipwhite skipempty
syntax match asemeReference_989 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeName_987 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_985,asemeComment_988 skipwhite skipempty
syntax region asemeComment_988 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_985,asemeComment_988 skipwhite skipempty
syntax match asemeComment_988 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_985,asemeComment_988 skipwhite skipempty
syntax match asemePunctuation_985 /\v\:/ contained nextgroup=asemeBuiltIn_983,asemeType_984,asemeComment_986 skipwhite skipempty
syntax region asemeComment_986 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_983,asemeType_984,asemeComment_986 skipwhite skipempty
syntax match asemeComment_986 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_983,asemeType_984,asemeComment_986 skipwhite skipempty
syntax match asemeType_984 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeBuiltIn_983 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemePunctuation_981 /\v\(/ contained nextgroup=asemeName_979,asemeComment_982 skipwhite skipempty
syntax region asemeComment_982 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_979,asemeComment_982 skipwhite skipempty
syntax match asemeComment_982 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_979,asemeComment_982 skipwhite skipempty
syntax match asemeName_979 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_977,asemeComment_980 skipwhite skipempty
syntax region asemeComment_980 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_977,asemeComment_980 skipwhite skipempty
syntax match asemeComment_980 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_977,asemeComment_980 skipwhite skipempty
syntax match asemePunctuation_977 /\v\:/ contained nextgroup=asemeBuiltIn_975,asemeType_976,asemeComment_978 skipwhite skipempty
syntax region asemeComment_978 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_975,asemeType_976,asemeComment_978 skipwhite skipempty
syntax match asemeComment_978 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_975,asemeType_976,asemeComment_978 skipwhite skipempty
syntax match asemeType_976 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeBuiltIn_975 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeChoice_974 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeChoice_973 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_972 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_970 /\vends%(<|>)/ contained nextgroup=asemeReference_969,asemeComment_971 skipwhite skipempty
syntax region asemeComment_971 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_969,asemeComment_971 skipwhite skipempty
syntax match asemeComment_971 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_969,asemeComment_971 skipwhite skipempty
syntax match asemeReference_969 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_967 /\vwrites%(<|>)/ contained nextgroup=asemeReference_966,asemeComment_968 skipwhite skipempty
syntax region asemeComment_968 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_966,asemeComment_968 skipwhite skipempty
syntax match asemeComment_968 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_966,asemeComment_968 skipwhite skipempty
syntax match asemeReference_966 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_964 /\vfor%(<|>)/ contained nextgroup=asemeNumber_963,asemeComment_965 skipwhite skipempty
syntax region asemeComment_965 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_963,asemeComment_965 skipwhite skipempty
syntax match asemeComment_965 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_963,asemeComment_965 skipwhite skipempty
syntax match asemeNumber_963 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeChoice_961 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_960,asemeComment_962 skipwhite skipempty
syntax region asemeComment_962 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_960,asemeComment_962 skipwhite skipempty
syntax match asemeComment_962 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_960,asemeComment_962 skipwhite skipempty
syntax match asemeReference_960 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_958 /\vuses%(<|>)/ contained nextgroup=asemeReference_957,asemeComment_959 skipwhite skipempty
syntax region asemeComment_959 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_957,asemeComment_959 skipwhite skipempty
syntax match asemeComment_959 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_957,asemeComment_959 skipwhite skipempty
syntax match asemeReference_957 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_955 /\vas%(<|>)/ contained nextgroup=asemeChoice_954,asemeComment_956 skipwhite skipempty
syntax region asemeComment_956 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_954,asemeComment_956 skipwhite skipempty
syntax match asemeComment_956 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_954,asemeComment_956 skipwhite skipempty
syntax match asemeChoice_954 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_952 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_951,asemeComment_953 skipwhite skipempty
syntax region asemeComment_953 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_951,asemeComment_953 skipwhite skipempty
syntax match asemeComment_953 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_951,asemeComment_953 skipwhite skipempty
syntax match asemeNumber_951 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_949 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_948,asemeComment_950 skipwhite skipempty
syntax region asemeComment_950 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_948,asemeComment_950 skipwhite skipempty
syntax match asemeComment_950 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_948,asemeComment_950 skipwhite skipempty
syntax match asemeNumber_948 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_946 /\vevery%(<|>)/ contained nextgroup=asemeNumber_945,asemeComment_947 skipwhite skipempty
syntax region asemeComment_947 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_945,asemeComment_947 skipwhite skipempty
syntax match asemeComment_947 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_945,asemeComment_947 skipwhite skipempty
syntax match asemeNumber_945 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeClause_943 /\vreads%(<|>)/ contained nextgroup=asemeChoice_940,asemeReference_942,asemeComment_944 skipwhite skipempty
syntax region asemeComment_944 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_940,asemeReference_942,asemeComment_944 skipwhite skipempty
syntax match asemeComment_944 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_940,asemeReference_942,asemeComment_944 skipwhite skipempty
syntax match asemeReference_942 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeChoice_940 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_938,asemeComment_941 skipwhite skipempty
syntax region asemeComment_941 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_938,asemeComment_941 skipwhite skipempty
syntax match asemeComment_941 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_938,asemeComment_941 skipwhite skipempty
syntax match asemeReference_938 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax region asemeComment_939 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeComment_939 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_939 skipwhite skipempty
syntax match asemeDeclaration_936 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_937 skipwhite skipempty
syntax region asemeComment_937 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_937 skipwhite skipempty
syntax match asemeComment_937 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_937 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_935
syntax region asemePunctuation_935 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_934,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeName_934 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_916,asemePunctuation_920,asemePunctuation_923,asemePunctuation_925,asemeOperator_933
syntax match asemeOperator_933 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemePunctuation_925 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax match asemePunctuation_923 /\v\,/ contained nextgroup=asemeName_922,asemeComment_924 skipwhite skipempty
syntax region asemeComment_924 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_922,asemeComment_924 skipwhite skipempty
syntax match asemeComment_924 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_922,asemeComment_924 skipwhite skipempty
syntax match asemeName_922 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax match asemePunctuation_920 /\v\:/ contained nextgroup=asemeBuiltIn_918,asemeType_919,asemeComment_921 skipwhite skipempty
syntax region asemeComment_921 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_918,asemeType_919,asemeComment_921 skipwhite skipempty
syntax match asemeComment_921 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_918,asemeType_919,asemeComment_921 skipwhite skipempty
syntax match asemeType_919 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax match asemeBuiltIn_918 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax match asemePunctuation_916 /\v\(/ contained nextgroup=asemeName_914,asemeComment_917 skipwhite skipempty
syntax region asemeComment_917 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_914,asemeComment_917 skipwhite skipempty
syntax match asemeComment_917 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_914,asemeComment_917 skipwhite skipempty
syntax match asemeName_914 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax region asemeComment_915 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax match asemeComment_915 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_915 skipwhite skipempty
syntax match asemeDeclaration_912 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_910,asemeComment_913 skipwhite skipempty
syntax region asemeComment_913 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_910,asemeComment_913 skipwhite skipempty
syntax match asemeComment_913 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_910,asemeComment_913 skipwhite skipempty
syntax match asemeName_910 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_909,asemeComment_911 skipwhite skipempty
syntax region asemeComment_911 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_909,asemeComment_911 skipwhite skipempty
syntax match asemeComment_911 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_909,asemeComment_911 skipwhite skipempty
syntax match asemeOperator_909 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeDeclaration_907 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_906,asemeComment_908 skipwhite skipempty
syntax region asemeComment_908 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_906,asemeComment_908 skipwhite skipempty
syntax match asemeComment_908 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_906,asemeComment_908 skipwhite skipempty
syntax match asemeName_906 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemeClause_849,asemeClause_851,asemePunctuation_855,asemeNumber_860,asemePunctuation_865,asemePunctuation_868,asemePunctuation_870,asemeOperator_904,asemeName_905
syntax match asemeName_905 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeOperator_904 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemePunctuation_870 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemePunctuation_868 /\v\.\./ contained nextgroup=asemeNumber_867,asemeComment_869 skipwhite skipempty
syntax region asemeComment_869 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_867,asemeComment_869 skipwhite skipempty
syntax match asemeComment_869 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_867,asemeComment_869 skipwhite skipempty
syntax match asemeNumber_867 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemePunctuation_865 /\v\:/ contained nextgroup=asemeClause_862,asemeBuiltIn_863,asemeType_864,asemeComment_866 skipwhite skipempty
syntax region asemeComment_866 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_862,asemeBuiltIn_863,asemeType_864,asemeComment_866 skipwhite skipempty
syntax match asemeComment_866 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_862,asemeBuiltIn_863,asemeType_864,asemeComment_866 skipwhite skipempty
syntax match asemeType_864 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeBuiltIn_863 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeClause_862 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeNumber_860 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_858,asemeComment_861 skipwhite skipempty
syntax region asemeComment_861 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_858,asemeComment_861 skipwhite skipempty
syntax match asemeComment_861 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_858,asemeComment_861 skipwhite skipempty
syntax match asemePunctuation_858 /\v\.\./ contained nextgroup=asemeNumber_857,asemeComment_859 skipwhite skipempty
syntax region asemeComment_859 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_857,asemeComment_859 skipwhite skipempty
syntax match asemeComment_859 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_857,asemeComment_859 skipwhite skipempty
syntax match asemeNumber_857 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemePunctuation_855 /\v\[/ contained nextgroup=asemeNumber_853,asemeComment_856 skipwhite skipempty
syntax region asemeComment_856 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_853,asemeComment_856 skipwhite skipempty
syntax match asemeComment_856 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_853,asemeComment_856 skipwhite skipempty
syntax match asemeNumber_853 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax region asemeComment_854 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax match asemeComment_854 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax match asemePunctuation_852 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeClause_851 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeClause_849 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_846,asemeType_848,asemeComment_850 skipwhite skipempty
syntax region asemeComment_850 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_846,asemeType_848,asemeComment_850 skipwhite skipempty
syntax match asemeComment_850 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_846,asemeType_848,asemeComment_850 skipwhite skipempty
syntax match asemeType_848 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeBuiltIn_846 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax region asemeComment_847 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeComment_847 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_847 skipwhite skipempty
syntax match asemeDeclaration_844 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_842,asemeComment_845 skipwhite skipempty
syntax region asemeComment_845 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_842,asemeComment_845 skipwhite skipempty
syntax match asemeComment_845 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_842,asemeComment_845 skipwhite skipempty
syntax match asemeName_842 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_841,@asemeCapabilityInBodyOfSrm,asemeComment_843 skipwhite skipempty
syntax region asemeComment_843 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_841,@asemeCapabilityInBodyOfSrm,asemeComment_843 skipwhite skipempty
syntax match asemeComment_843 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_841,@asemeCapabilityInBodyOfSrm,asemeComment_843 skipwhite skipempty
syntax match asemeText_841 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_832,asemePunctuation_835,asemeText_837,asemeName_839
syntax match asemeName_839 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_838,@asemeCapabilityInBodyOfSrm,asemeComment_840 skipwhite skipempty
syntax region asemeComment_840 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_838,@asemeCapabilityInBodyOfSrm,asemeComment_840 skipwhite skipempty
syntax match asemeComment_840 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_838,@asemeCapabilityInBodyOfSrm,asemeComment_840 skipwhite skipempty
syntax match asemeText_838 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax match asemeText_837 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax match asemePunctuation_835 /\v\,/ contained nextgroup=asemeReference_834,asemeComment_836 skipwhite skipempty
syntax region asemeComment_836 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_834,asemeComment_836 skipwhite skipempty
syntax match asemeComment_836 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_834,asemeComment_836 skipwhite skipempty
syntax match asemeReference_834 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax match asemeOperator_832 /\v\=%(\=)@!/ contained nextgroup=asemeReference_830,asemeComment_833 skipwhite skipempty
syntax region asemeComment_833 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_830,asemeComment_833 skipwhite skipempty
syntax match asemeComment_833 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_830,asemeComment_833 skipwhite skipempty
syntax match asemeReference_830 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax region asemeComment_831 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax match asemeComment_831 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_831 skipwhite skipempty
syntax match asemeDeclaration_828 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_826,asemeComment_829 skipwhite skipempty
syntax region asemeComment_829 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_826,asemeComment_829 skipwhite skipempty
syntax match asemeComment_829 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_826,asemeComment_829 skipwhite skipempty
syntax match asemeReference_826 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_824,asemeComment_827 skipwhite skipempty
syntax region asemeComment_827 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_824,asemeComment_827 skipwhite skipempty
syntax match asemeComment_827 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_824,asemeComment_827 skipwhite skipempty
syntax match asemePunctuation_824 /\v\./ contained nextgroup=asemeReference_823,asemeComment_825 skipwhite skipempty
syntax region asemeComment_825 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_823,asemeComment_825 skipwhite skipempty
syntax match asemeComment_825 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_823,asemeComment_825 skipwhite skipempty
syntax match asemeReference_823 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_765,asemeClause_769,asemeClause_800,asemeClause_802,asemePunctuation_811,asemePunctuation_814,asemeOperator_816,asemeReference_820,asemeReference_822
syntax match asemeReference_822 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax match asemeReference_820 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_818,asemeComment_821 skipwhite skipempty
syntax region asemeComment_821 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_818,asemeComment_821 skipwhite skipempty
syntax match asemeComment_821 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_818,asemeComment_821 skipwhite skipempty
syntax match asemePunctuation_818 /\v\./ contained nextgroup=asemeReference_817,asemeComment_819 skipwhite skipempty
syntax region asemeComment_819 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_817,asemeComment_819 skipwhite skipempty
syntax match asemeComment_819 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_817,asemeComment_819 skipwhite skipempty
syntax match asemeReference_817 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax match asemeOperator_816 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemePunctuation_814 /\v\./ contained nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax region asemeComment_815 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax match asemeComment_815 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax match asemeReference_813 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax match asemePunctuation_811 /\v\,/ contained nextgroup=asemeReference_806,asemeReference_809,asemeComment_812 skipwhite skipempty
syntax region asemeComment_812 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_806,asemeReference_809,asemeComment_812 skipwhite skipempty
syntax match asemeComment_812 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_806,asemeReference_809,asemeComment_812 skipwhite skipempty
syntax match asemeReference_809 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_808,asemeComment_810 skipwhite skipempty
syntax region asemeComment_810 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_808,asemeComment_810 skipwhite skipempty
syntax match asemeComment_810 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_808,asemeComment_810 skipwhite skipempty
syntax match asemeOperator_808 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeReference_806 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_804,asemeComment_807 skipwhite skipempty
syntax region asemeComment_807 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_804,asemeComment_807 skipwhite skipempty
syntax match asemeComment_807 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_804,asemeComment_807 skipwhite skipempty
syntax match asemePunctuation_804 /\v\./ contained nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax region asemeComment_805 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax match asemeComment_805 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax match asemeReference_803 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax match asemeClause_802 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_800 /\vwhen%(<|>)/ contained nextgroup=asemeClause_799,asemeComment_801 skipwhite skipempty
syntax region asemeComment_801 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_799,asemeComment_801 skipwhite skipempty
syntax match asemeComment_801 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_799,asemeComment_801 skipwhite skipempty
syntax match asemeClause_799 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_769 /\vas%(<|>)/ contained nextgroup=asemeReference_767,asemeComment_770 skipwhite skipempty
syntax region asemeComment_770 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_767,asemeComment_770 skipwhite skipempty
syntax match asemeComment_770 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_767,asemeComment_770 skipwhite skipempty
syntax match asemeReference_767 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax region asemeComment_768 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax match asemeComment_768 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_768 skipwhite skipempty
syntax match asemeClause_765 /\vwith%(<|>)/ contained nextgroup=asemeReference_763,asemeComment_766 skipwhite skipempty
syntax region asemeComment_766 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_763,asemeComment_766 skipwhite skipempty
syntax match asemeComment_766 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_763,asemeComment_766 skipwhite skipempty
syntax match asemeReference_763 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_762,asemeComment_764 skipwhite skipempty
syntax region asemeComment_764 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_762,asemeComment_764 skipwhite skipempty
syntax match asemeComment_764 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_762,asemeComment_764 skipwhite skipempty
syntax match asemeOperator_762 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeDeclaration_727 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_726,asemeComment_728 skipwhite skipempty
syntax region asemeComment_728 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_726,asemeComment_728 skipwhite skipempty
syntax match asemeComment_728 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_726,asemeComment_728 skipwhite skipempty
syntax match asemeReference_726 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_723,asemeReference_725
syntax match asemeReference_725 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemePunctuation_723 /\v\,/ contained nextgroup=asemeReference_721,asemeComment_724 skipwhite skipempty
syntax region asemeComment_724 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_721,asemeComment_724 skipwhite skipempty
syntax match asemeComment_724 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_721,asemeComment_724 skipwhite skipempty
syntax match asemeReference_721 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax region asemeComment_722 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemeComment_722 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemeClause_719 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_717,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_717,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_717,asemeComment_720 skipwhite skipempty
syntax match asemeBlock_717 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_718 skipwhite skipempty
syntax region asemeComment_718 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_718 skipwhite skipempty
syntax match asemeComment_718 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_718 skipwhite skipempty
syntax match asemeDeclaration_715 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_714,asemeComment_716 skipwhite skipempty
syntax region asemeComment_716 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_714,asemeComment_716 skipwhite skipempty
syntax match asemeComment_716 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_714,asemeComment_716 skipwhite skipempty
syntax match asemeBlock_714 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_713 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_711,asemeBlock_712
syntax match asemeBlock_712 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_713 skipwhite skipempty
syntax region asemeComment_713 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_713 skipwhite skipempty
syntax match asemeComment_713 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_713 skipwhite skipempty
syntax region asemePunctuation_711 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_561,asemeDeclaration_564,asemeDeclaration_597,asemeDeclaration_601,asemeDeclaration_709,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_709 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_707,asemeComment_710 skipwhite skipempty
syntax region asemeComment_710 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_707,asemeComment_710 skipwhite skipempty
syntax match asemeComment_710 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_707,asemeComment_710 skipwhite skipempty
syntax match asemeBlock_707 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_704,asemeOperator_706,@asemeControlInBodyOfAip,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_704,asemeOperator_706,@asemeControlInBodyOfAip,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_704,asemeOperator_706,@asemeControlInBodyOfAip,asemeComment_708 skipwhite skipempty
syntax match asemeOperator_706 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax match asemeOperator_704 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_703,@asemeControlInBodyOfAip,asemeComment_705 skipwhite skipempty
syntax region asemeComment_705 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_703,@asemeControlInBodyOfAip,asemeComment_705 skipwhite skipempty
syntax match asemeComment_705 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_703,@asemeControlInBodyOfAip,asemeComment_705 skipwhite skipempty
syntax match asemeOperator_703 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemeOperator_605,asemePunctuation_695,asemeOperator_696,asemeBlock_701
syntax match asemeBlock_701 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_698,asemeOperator_700,@asemeControlInBodyOfAip,asemeComment_702 skipwhite skipempty
syntax region asemeComment_702 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_698,asemeOperator_700,@asemeControlInBodyOfAip,asemeComment_702 skipwhite skipempty
syntax match asemeComment_702 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_698,asemeOperator_700,@asemeControlInBodyOfAip,asemeComment_702 skipwhite skipempty
syntax match asemeOperator_700 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax match asemeOperator_698 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_697,@asemeControlInBodyOfAip,asemeComment_699 skipwhite skipempty
syntax region asemeComment_699 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_697,@asemeControlInBodyOfAip,asemeComment_699 skipwhite skipempty
syntax match asemeComment_699 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_697,@asemeControlInBodyOfAip,asemeComment_699 skipwhite skipempty
syntax match asemeOperator_697 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax match asemeOperator_696 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax region asemePunctuation_695 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_654,asemeNumber_693,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeNumber_693 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_691,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_691,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_691,asemeComment_694 skipwhite skipempty
syntax match asemeOperator_691 /\v\-\>/ contained nextgroup=asemeNumber_689,asemeComment_692 skipwhite skipempty
syntax region asemeComment_692 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_689,asemeComment_692 skipwhite skipempty
syntax match asemeComment_692 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_689,asemeComment_692 skipwhite skipempty
syntax match asemeNumber_689 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax region asemeComment_690 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax match asemeComment_690 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax match asemePunctuation_688 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeDeclaration_654 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_609,asemeOperator_612,asemePunctuation_647,asemeText_648,asemeNumber_649,asemeReference_650,asemeNumber_651,asemeOperator_652,asemePunctuation_653
syntax match asemePunctuation_653 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeOperator_652 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeNumber_651 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeReference_650 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeNumber_649 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeText_648 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemePunctuation_647 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeOperator_612 /\v\#/ contained nextgroup=asemeNumber_611,asemeComment_613 skipwhite skipempty
syntax region asemeComment_613 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_611,asemeComment_613 skipwhite skipempty
syntax match asemeComment_613 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_611,asemeComment_613 skipwhite skipempty
syntax match asemeNumber_611 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeClause_609 /\vevery%(<|>)/ contained nextgroup=asemeNumber_607,asemeComment_610 skipwhite skipempty
syntax region asemeComment_610 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_607,asemeComment_610 skipwhite skipempty
syntax match asemeComment_610 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_607,asemeComment_610 skipwhite skipempty
syntax match asemeNumber_607 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax region asemeComment_608 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeComment_608 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_608 skipwhite skipempty
syntax match asemeOperator_605 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_603,@asemeControlInBodyOfAip,asemeComment_606 skipwhite skipempty
syntax region asemeComment_606 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_603,@asemeControlInBodyOfAip,asemeComment_606 skipwhite skipempty
syntax match asemeComment_606 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_603,@asemeControlInBodyOfAip,asemeComment_606 skipwhite skipempty
syntax match asemeOperator_603 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_604 skipwhite skipempty
syntax match asemeDeclaration_601 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_599,asemeComment_602 skipwhite skipempty
syntax region asemeComment_602 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_599,asemeComment_602 skipwhite skipempty
syntax match asemeComment_602 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_599,asemeComment_602 skipwhite skipempty
syntax match asemeName_599 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_598,asemeComment_600 skipwhite skipempty
syntax region asemeComment_600 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_598,asemeComment_600 skipwhite skipempty
syntax match asemeComment_600 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_598,asemeComment_600 skipwhite skipempty
syntax match asemeOperator_598 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeDeclaration_597 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_571,asemeClause_575,asemeClause_578,asemeClause_581,asemeClause_584,asemeClause_586,asemeClause_587,asemeClause_588,asemePunctuation_590,asemeOperator_593,asemePunctuation_595,asemeName_596
syntax match asemeName_596 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemePunctuation_595 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeOperator_593 /\v\@/ contained nextgroup=asemeReference_592,asemeComment_594 skipwhite skipempty
syntax region asemeComment_594 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_592,asemeComment_594 skipwhite skipempty
syntax match asemeComment_594 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_592,asemeComment_594 skipwhite skipempty
syntax match asemeReference_592 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemePunctuation_590 /\v\(/ contained nextgroup=asemeName_589,asemeComment_591 skipwhite skipempty
syntax region asemeComment_591 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_589,asemeComment_591 skipwhite skipempty
syntax match asemeComment_591 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_589,asemeComment_591 skipwhite skipempty
syntax match asemeName_589 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_588 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_587 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_586 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_584 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_583,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_583,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_583,asemeComment_585 skipwhite skipempty
syntax match asemeNumber_583 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_581 /\vleads%(<|>)/ contained nextgroup=asemeClause_580,asemeComment_582 skipwhite skipempty
syntax region asemeComment_582 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_580,asemeComment_582 skipwhite skipempty
syntax match asemeComment_582 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_580,asemeComment_582 skipwhite skipempty
syntax match asemeClause_580 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_578 /\vor%(<|>)/ contained nextgroup=asemeName_577,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_577,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_577,asemeComment_579 skipwhite skipempty
syntax match asemeName_577 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_575 /\vmost%(<|>)/ contained nextgroup=asemeChoice_573,asemeNumber_574,asemeComment_576 skipwhite skipempty
syntax region asemeComment_576 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_573,asemeNumber_574,asemeComment_576 skipwhite skipempty
syntax match asemeComment_576 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_573,asemeNumber_574,asemeComment_576 skipwhite skipempty
syntax match asemeNumber_574 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeChoice_573 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeClause_571 /\vat%(<|>)/ contained nextgroup=asemeClause_569,asemeComment_572 skipwhite skipempty
syntax region asemeComment_572 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_569,asemeComment_572 skipwhite skipempty
syntax match asemeComment_572 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_569,asemeComment_572 skipwhite skipempty
syntax match asemeClause_569 /\vmost%(<|>)/ contained nextgroup=asemeChoice_566,asemeNumber_568,asemeComment_570 skipwhite skipempty
syntax region asemeComment_570 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_566,asemeNumber_568,asemeComment_570 skipwhite skipempty
syntax match asemeComment_570 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_566,asemeNumber_568,asemeComment_570 skipwhite skipempty
syntax match asemeNumber_568 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeChoice_566 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax region asemeComment_567 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeComment_567 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_567 skipwhite skipempty
syntax match asemeDeclaration_564 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_563,asemeComment_565 skipwhite skipempty
syntax region asemeComment_565 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_563,asemeComment_565 skipwhite skipempty
syntax match asemeComment_565 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_563,asemeComment_565 skipwhite skipempty
syntax match asemeText_563 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_561 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_560,asemeComment_562 skipwhite skipempty
syntax region asemeComment_562 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_560,asemeComment_562 skipwhite skipempty
syntax match asemeComment_562 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_560,asemeComment_562 skipwhite skipempty
syntax match asemeBlock_560 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_253,asemePunctuation_256,asemePunctuation_258,asemePunctuation_558,asemeBlock_559
syntax match asemeBlock_559 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax region asemePunctuation_558 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_260,asemeDeclaration_361,asemeDeclaration_424,asemeDeclaration_432,asemeDeclaration_495,asemeDeclaration_500,asemeDeclaration_521,asemeDeclaration_535,asemeName_557,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeName_557 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_539,asemePunctuation_543,asemePunctuation_546,asemePunctuation_548,asemeOperator_556
syntax match asemeOperator_556 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemePunctuation_548 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemePunctuation_546 /\v\,/ contained nextgroup=asemeName_545,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_545,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_545,asemeComment_547 skipwhite skipempty
syntax match asemeName_545 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemePunctuation_543 /\v\:/ contained nextgroup=asemeBuiltIn_541,asemeType_542,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_541,asemeType_542,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_541,asemeType_542,asemeComment_544 skipwhite skipempty
syntax match asemeType_542 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeBuiltIn_541 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemePunctuation_539 /\v\(/ contained nextgroup=asemeName_537,asemeComment_540 skipwhite skipempty
syntax region asemeComment_540 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_537,asemeComment_540 skipwhite skipempty
syntax match asemeComment_540 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_537,asemeComment_540 skipwhite skipempty
syntax match asemeName_537 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeDeclaration_535 /\v%(receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_533,asemeComment_536 skipwhite skipempty
syntax region asemeComment_536 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_533,asemeComment_536 skipwhite skipempty
syntax match asemeComment_536 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_533,asemeComment_536 skipwhite skipempty
syntax match asemeReference_533 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_532,asemeComment_534 skipwhite skipempty
syntax region asemeComment_534 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_532,asemeComment_534 skipwhite skipempty
syntax match asemeComment_534 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_532,asemeComment_534 skipwhite skipempty
syntax match asemeReference_532 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_527,asemeReference_530
syntax match asemeReference_530 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_529,@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax region asemeComment_531 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_529,@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax match asemeComment_531 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_529,@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax match asemeReference_529 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax match asemePunctuation_527 /\v\,/ contained nextgroup=asemeReference_525,asemeComment_528 skipwhite skipempty
syntax region asemeComment_528 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_525,asemeComment_528 skipwhite skipempty
syntax match asemeComment_528 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_525,asemeComment_528 skipwhite skipempty
syntax match asemeReference_525 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_523,asemeComment_526 skipwhite skipempty
syntax region asemeComment_526 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_523,asemeComment_526 skipwhite skipempty
syntax match asemeComment_526 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_523,asemeComment_526 skipwhite skipempty
syntax match asemeReference_523 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax region asemeComment_524 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax match asemeComment_524 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax match asemeDeclaration_521 /\v%(sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax region asemeComment_522 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax match asemeComment_522 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_519,asemeComment_522 skipwhite skipempty
syntax match asemeReference_519 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax region asemeComment_520 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax match asemeComment_520 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax match asemeReference_518 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_504,asemeClause_507,asemeClause_509,asemePunctuation_513,asemeReference_516
syntax match asemeReference_516 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_515,@asemeSendsInBodyOfParticipant,asemeComment_517 skipwhite skipempty
syntax region asemeComment_517 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_515,@asemeSendsInBodyOfParticipant,asemeComment_517 skipwhite skipempty
syntax match asemeComment_517 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_515,@asemeSendsInBodyOfParticipant,asemeComment_517 skipwhite skipempty
syntax match asemeReference_515 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax match asemePunctuation_513 /\v\,/ contained nextgroup=asemeReference_511,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_511,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_511,asemeComment_514 skipwhite skipempty
syntax match asemeReference_511 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_510,asemeComment_512 skipwhite skipempty
syntax region asemeComment_512 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_510,asemeComment_512 skipwhite skipempty
syntax match asemeComment_512 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_510,asemeComment_512 skipwhite skipempty
syntax match asemeReference_510 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax match asemeClause_509 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax match asemeClause_507 /\vor%(<|>)/ contained nextgroup=asemeReference_506,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_506,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_506,asemeComment_508 skipwhite skipempty
syntax match asemeReference_506 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax match asemeClause_504 /\vby%(<|>)/ contained nextgroup=asemeReference_502,asemeComment_505 skipwhite skipempty
syntax region asemeComment_505 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_502,asemeComment_505 skipwhite skipempty
syntax match asemeComment_505 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_502,asemeComment_505 skipwhite skipempty
syntax match asemeReference_502 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax region asemeComment_503 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax match asemeComment_503 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_503 skipwhite skipempty
syntax match asemeDeclaration_500 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_498,asemeComment_501 skipwhite skipempty
syntax region asemeComment_501 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_498,asemeComment_501 skipwhite skipempty
syntax match asemeComment_501 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_498,asemeComment_501 skipwhite skipempty
syntax match asemeName_498 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_497,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_497,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_497,asemeComment_499 skipwhite skipempty
syntax match asemeOperator_497 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeDeclaration_495 /\v%(result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=result%(<|>)/ contained nextgroup=asemeName_493,asemeComment_496 skipwhite skipempty
syntax region asemeComment_496 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_493,asemeComment_496 skipwhite skipempty
syntax match asemeComment_496 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_493,asemeComment_496 skipwhite skipempty
syntax match asemeName_493 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_491,asemeComment_494 skipwhite skipempty
syntax region asemeComment_494 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_491,asemeComment_494 skipwhite skipempty
syntax match asemeComment_494 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_491,asemeComment_494 skipwhite skipempty
syntax match asemePunctuation_491 /\v\:/ contained nextgroup=asemeBuiltIn_489,asemeType_490,asemeComment_492 skipwhite skipempty
syntax region asemeComment_492 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_489,asemeType_490,asemeComment_492 skipwhite skipempty
syntax match asemeComment_492 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_489,asemeType_490,asemeComment_492 skipwhite skipempty
syntax match asemeType_490 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeBuiltIn_489 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax cluster asemeResultInBodyOfParticipant contains=asemeNumber_438,asemePunctuation_441,asemePunctuation_445,asemeOperator_480,asemeName_485,asemeBuiltIn_487,asemeType_488
syntax match asemeType_488 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeBuiltIn_487 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeName_485 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_483,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_483,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_483,asemeComment_486 skipwhite skipempty
syntax match asemePunctuation_483 /\v\:/ contained nextgroup=asemeBuiltIn_481,asemeType_482,asemeComment_484 skipwhite skipempty
syntax region asemeComment_484 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_481,asemeType_482,asemeComment_484 skipwhite skipempty
syntax match asemeComment_484 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_481,asemeType_482,asemeComment_484 skipwhite skipempty
syntax match asemeType_482 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeBuiltIn_481 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeOperator_480 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemePunctuation_445 /\v\:/ contained nextgroup=asemeBuiltIn_443,asemeType_444,asemeComment_446 skipwhite skipempty
syntax region asemeComment_446 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_443,asemeType_444,asemeComment_446 skipwhite skipempty
syntax match asemeComment_446 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_443,asemeType_444,asemeComment_446 skipwhite skipempty
syntax match asemeType_444 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeBuiltIn_443 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemePunctuation_441 /\v\.\./ contained nextgroup=asemeNumber_440,asemeComment_442 skipwhite skipempty
syntax region asemeComment_442 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_440,asemeComment_442 skipwhite skipempty
syntax match asemeComment_442 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_440,asemeComment_442 skipwhite skipempty
syntax match asemeNumber_440 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeNumber_438 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_436,asemeComment_439 skipwhite skipempty
syntax region asemeComment_439 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_436,asemeComment_439 skipwhite skipempty
syntax match asemeComment_439 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_436,asemeComment_439 skipwhite skipempty
syntax match asemePunctuation_436 /\v\.\./ contained nextgroup=asemeNumber_434,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_434,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_434,asemeComment_437 skipwhite skipempty
syntax match asemeNumber_434 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax region asemeComment_435 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeComment_435 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeDeclaration_432 /\v%(given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=given%(<|>)/ contained nextgroup=asemeName_430,asemeComment_433 skipwhite skipempty
syntax region asemeComment_433 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_430,asemeComment_433 skipwhite skipempty
syntax match asemeComment_433 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_430,asemeComment_433 skipwhite skipempty
syntax match asemeName_430 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_428,asemeComment_431 skipwhite skipempty
syntax region asemeComment_431 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_428,asemeComment_431 skipwhite skipempty
syntax match asemeComment_431 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_428,asemeComment_431 skipwhite skipempty
syntax match asemePunctuation_428 /\v\:/ contained nextgroup=asemeBuiltIn_426,asemeType_427,asemeComment_429 skipwhite skipempty
syntax region asemeComment_429 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_426,asemeType_427,asemeComment_429 skipwhite skipempty
syntax match asemeComment_429 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_426,asemeType_427,asemeComment_429 skipwhite skipempty
syntax match asemeType_427 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained
syntax match asemeBuiltIn_426 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained
syntax match asemeDeclaration_424 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_423,asemeComment_425 skipwhite skipempty
syntax region asemeComment_425 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_423,asemeComment_425 skipwhite skipempty
syntax match asemeComment_425 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_423,asemeComment_425 skipwhite skipempty
syntax match asemeName_423 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemeClause_366,asemeClause_368,asemePunctuation_372,asemeNumber_377,asemePunctuation_382,asemePunctuation_385,asemePunctuation_387,asemeOperator_421,asemeName_422
syntax match asemeName_422 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeOperator_421 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemePunctuation_387 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemePunctuation_385 /\v\.\./ contained nextgroup=asemeNumber_384,asemeComment_386 skipwhite skipempty
syntax region asemeComment_386 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_384,asemeComment_386 skipwhite skipempty
syntax match asemeComment_386 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_384,asemeComment_386 skipwhite skipempty
syntax match asemeNumber_384 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemePunctuation_382 /\v\:/ contained nextgroup=asemeClause_379,asemeBuiltIn_380,asemeType_381,asemeComment_383 skipwhite skipempty
syntax region asemeComment_383 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_379,asemeBuiltIn_380,asemeType_381,asemeComment_383 skipwhite skipempty
syntax match asemeComment_383 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_379,asemeBuiltIn_380,asemeType_381,asemeComment_383 skipwhite skipempty
syntax match asemeType_381 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeBuiltIn_380 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeClause_379 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeNumber_377 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_375,asemeComment_378 skipwhite skipempty
syntax region asemeComment_378 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_375,asemeComment_378 skipwhite skipempty
syntax match asemeComment_378 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_375,asemeComment_378 skipwhite skipempty
syntax match asemePunctuation_375 /\v\.\./ contained nextgroup=asemeNumber_374,asemeComment_376 skipwhite skipempty
syntax region asemeComment_376 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_374,asemeComment_376 skipwhite skipempty
syntax match asemeComment_376 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_374,asemeComment_376 skipwhite skipempty
syntax match asemeNumber_374 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemePunctuation_372 /\v\[/ contained nextgroup=asemeNumber_370,asemeComment_373 skipwhite skipempty
syntax region asemeComment_373 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_370,asemeComment_373 skipwhite skipempty
syntax match asemeComment_373 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_370,asemeComment_373 skipwhite skipempty
syntax match asemeNumber_370 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_369,asemeComment_371 skipwhite skipempty
syntax region asemeComment_371 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_369,asemeComment_371 skipwhite skipempty
syntax match asemeComment_371 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_369,asemeComment_371 skipwhite skipempty
syntax match asemePunctuation_369 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeClause_368 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeClause_366 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_363,asemeType_365,asemeComment_367 skipwhite skipempty
syntax region asemeComment_367 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_363,asemeType_365,asemeComment_367 skipwhite skipempty
syntax match asemeComment_367 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_363,asemeType_365,asemeComment_367 skipwhite skipempty
syntax match asemeType_365 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeBuiltIn_363 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax region asemeComment_364 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeComment_364 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_364 skipwhite skipempty
syntax match asemeDeclaration_361 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_359,asemeComment_362 skipwhite skipempty
syntax region asemeComment_362 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_359,asemeComment_362 skipwhite skipempty
syntax match asemeComment_362 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_359,asemeComment_362 skipwhite skipempty
syntax match asemeReference_359 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_357,asemeComment_360 skipwhite skipempty
syntax region asemeComment_360 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_357,asemeComment_360 skipwhite skipempty
syntax match asemeComment_360 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_357,asemeComment_360 skipwhite skipempty
syntax match asemePunctuation_357 /\v\./ contained nextgroup=asemeReference_356,asemeComment_358 skipwhite skipempty
syntax region asemeComment_358 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_356,asemeComment_358 skipwhite skipempty
syntax match asemeComment_358 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_356,asemeComment_358 skipwhite skipempty
syntax match asemeReference_356 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax cluster asemePlaysInBodyOfParticipant contains=asemeClause_298,asemeClause_302,asemeClause_333,asemeClause_335,asemePunctuation_344,asemePunctuation_347,asemeOperator_349,asemeReference_353,asemeReference_355
syntax match asemeReference_355 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeReference_353 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_351,asemeComment_354 skipwhite skipempty
syntax region asemeComment_354 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_351,asemeComment_354 skipwhite skipempty
syntax match asemeComment_354 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_351,asemeComment_354 skipwhite skipempty
syntax match asemePunctuation_351 /\v\./ contained nextgroup=asemeReference_350,asemeComment_352 skipwhite skipempty
syntax region asemeComment_352 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_350,asemeComment_352 skipwhite skipempty
syntax match asemeComment_352 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_350,asemeComment_352 skipwhite skipempty
syntax match asemeReference_350 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeOperator_349 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemePunctuation_347 /\v\./ contained nextgroup=asemeReference_346,asemeComment_348 skipwhite skipempty
syntax region asemeComment_348 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_346,asemeComment_348 skipwhite skipempty
syntax match asemeComment_348 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_346,asemeComment_348 skipwhite skipempty
syntax match asemeReference_346 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemePunctuation_344 /\v\,/ contained nextgroup=asemeReference_339,asemeReference_342,asemeComment_345 skipwhite skipempty
syntax region asemeComment_345 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_339,asemeReference_342,asemeComment_345 skipwhite skipempty
syntax match asemeComment_345 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_339,asemeReference_342,asemeComment_345 skipwhite skipempty
syntax match asemeReference_342 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_341,asemeComment_343 skipwhite skipempty
syntax region asemeComment_343 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_341,asemeComment_343 skipwhite skipempty
syntax match asemeComment_343 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_341,asemeComment_343 skipwhite skipempty
syntax match asemeOperator_341 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeReference_339 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_337,asemeComment_340 skipwhite skipempty
syntax region asemeComment_340 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_337,asemeComment_340 skipwhite skipempty
syntax match asemeComment_340 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_337,asemeComment_340 skipwhite skipempty
syntax match asemePunctuation_337 /\v\./ contained nextgroup=asemeReference_336,asemeComment_338 skipwhite skipempty
syntax region asemeComment_338 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_336,asemeComment_338 skipwhite skipempty
syntax match asemeComment_338 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_336,asemeComment_338 skipwhite skipempty
syntax match asemeReference_336 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_335 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_333 /\vwhen%(<|>)/ contained nextgroup=asemeClause_332,asemeComment_334 skipwhite skipempty
syntax region asemeComment_334 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_332,asemeComment_334 skipwhite skipempty
syntax match asemeComment_334 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_332,asemeComment_334 skipwhite skipempty
syntax match asemeClause_332 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_302 /\vas%(<|>)/ contained nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax region asemeComment_303 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax match asemeComment_303 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax match asemeReference_300 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_301 skipwhite skipempty
syntax match asemeClause_298 /\vwith%(<|>)/ contained nextgroup=asemeReference_296,asemeComment_299 skipwhite skipempty
syntax region asemeComment_299 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_296,asemeComment_299 skipwhite skipempty
syntax match asemeComment_299 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_296,asemeComment_299 skipwhite skipempty
syntax match asemeReference_296 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_295,asemeComment_297 skipwhite skipempty
syntax region asemeComment_297 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_295,asemeComment_297 skipwhite skipempty
syntax match asemeComment_297 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_295,asemeComment_297 skipwhite skipempty
syntax match asemeOperator_295 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeDeclaration_260 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_259,asemeComment_261 skipwhite skipempty
syntax region asemeComment_261 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_259,asemeComment_261 skipwhite skipempty
syntax match asemeComment_261 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_259,asemeComment_261 skipwhite skipempty
syntax match asemeText_259 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_258 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax match asemePunctuation_256 /\v\.\./ contained nextgroup=asemeNumber_255,asemeComment_257 skipwhite skipempty
syntax region asemeComment_257 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_255,asemeComment_257 skipwhite skipempty
syntax match asemeComment_257 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_255,asemeComment_257 skipwhite skipempty
syntax match asemeNumber_255 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax match asemePunctuation_253 /\v\[/ contained nextgroup=asemeNumber_251,asemeComment_254 skipwhite skipempty
syntax region asemeComment_254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_251,asemeComment_254 skipwhite skipempty
syntax match asemeComment_254 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_251,asemeComment_254 skipwhite skipempty
syntax match asemeNumber_251 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax region asemeComment_252 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax match asemeComment_252 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_252 skipwhite skipempty
syntax match asemeDeclaration_249 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_250 skipwhite skipempty
syntax region asemeComment_250 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_250 skipwhite skipempty
syntax match asemeComment_250 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_250 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_248
syntax region asemePunctuation_248 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_228,asemeDeclaration_246,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_246 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_245,asemeComment_247 skipwhite skipempty
syntax region asemeComment_247 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_245,asemeComment_247 skipwhite skipempty
syntax match asemeComment_247 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_245,asemeComment_247 skipwhite skipempty
syntax match asemeName_245 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_232,asemeClause_235,asemeClause_238,asemePunctuation_241,asemeText_243,asemeName_244
syntax match asemeName_244 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemeText_243 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemePunctuation_241 /\v\,/ contained nextgroup=asemeReference_240,asemeComment_242 skipwhite skipempty
syntax region asemeComment_242 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_240,asemeComment_242 skipwhite skipempty
syntax match asemeComment_242 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_240,asemeComment_242 skipwhite skipempty
syntax match asemeReference_240 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemeClause_238 /\vrealises%(<|>)/ contained nextgroup=asemeReference_237,asemeComment_239 skipwhite skipempty
syntax region asemeComment_239 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_237,asemeComment_239 skipwhite skipempty
syntax match asemeComment_239 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_237,asemeComment_239 skipwhite skipempty
syntax match asemeReference_237 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemeClause_235 /\vincludes%(<|>)/ contained nextgroup=asemeReference_234,asemeComment_236 skipwhite skipempty
syntax region asemeComment_236 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_234,asemeComment_236 skipwhite skipempty
syntax match asemeComment_236 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_234,asemeComment_236 skipwhite skipempty
syntax match asemeReference_234 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemeClause_232 /\vby%(<|>)/ contained nextgroup=asemeReference_230,asemeComment_233 skipwhite skipempty
syntax region asemeComment_233 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_230,asemeComment_233 skipwhite skipempty
syntax match asemeComment_233 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_230,asemeComment_233 skipwhite skipempty
syntax match asemeReference_230 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax region asemeComment_231 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemeComment_231 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_231 skipwhite skipempty
syntax match asemeDeclaration_228 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_227,asemeComment_229 skipwhite skipempty
syntax region asemeComment_229 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_227,asemeComment_229 skipwhite skipempty
syntax match asemeComment_229 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_227,asemeComment_229 skipwhite skipempty
syntax match asemeReference_227 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemeChoice_218,asemePunctuation_221,asemePunctuation_224,asemeReference_226
syntax match asemeReference_226 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax match asemePunctuation_224 /\v\:/ contained nextgroup=asemeChoice_223,asemeComment_225 skipwhite skipempty
syntax region asemeComment_225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_223,asemeComment_225 skipwhite skipempty
syntax match asemeComment_225 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_223,asemeComment_225 skipwhite skipempty
syntax match asemeChoice_223 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax match asemePunctuation_221 /\v\,/ contained nextgroup=asemeReference_220,asemeComment_222 skipwhite skipempty
syntax region asemeComment_222 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_220,asemeComment_222 skipwhite skipempty
syntax match asemeComment_222 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_220,asemeComment_222 skipwhite skipempty
syntax match asemeReference_220 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax match asemeChoice_218 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax region asemeComment_219 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax match asemeComment_219 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_219 skipwhite skipempty
syntax match asemeDeclaration_216 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_217 skipwhite skipempty
syntax region asemeComment_217 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_217 skipwhite skipempty
syntax match asemeComment_217 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_217 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_215
syntax region asemePunctuation_215 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_213,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_213 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_212,asemeComment_214 skipwhite skipempty
syntax region asemeComment_214 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_212,asemeComment_214 skipwhite skipempty
syntax match asemeComment_214 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_212,asemeComment_214 skipwhite skipempty
syntax match asemeBlock_212 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_211 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_209,asemeBlock_210
syntax match asemeBlock_210 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_211 skipwhite skipempty
syntax region asemeComment_211 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_211 skipwhite skipempty
syntax match asemeComment_211 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_211 skipwhite skipempty
syntax region asemePunctuation_209 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_207,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_207 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_206,asemeComment_208 skipwhite skipempty
syntax region asemeComment_208 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_206,asemeComment_208 skipwhite skipempty
syntax match asemeComment_208 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_206,asemeComment_208 skipwhite skipempty
syntax match asemeName_206 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_196,asemeClause_199,asemePunctuation_202,asemeText_204,asemeName_205
syntax match asemeName_205 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax match asemeText_204 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax match asemePunctuation_202 /\v\,/ contained nextgroup=asemeReference_201,asemeComment_203 skipwhite skipempty
syntax region asemeComment_203 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_201,asemeComment_203 skipwhite skipempty
syntax match asemeComment_203 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_201,asemeComment_203 skipwhite skipempty
syntax match asemeReference_201 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax match asemeClause_199 /\von%(<|>)/ contained nextgroup=asemeReference_198,asemeComment_200 skipwhite skipempty
syntax region asemeComment_200 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_198,asemeComment_200 skipwhite skipempty
syntax match asemeComment_200 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_198,asemeComment_200 skipwhite skipempty
syntax match asemeReference_198 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax match asemeClause_196 /\vdepends%(<|>)/ contained nextgroup=asemeClause_194,asemeComment_197 skipwhite skipempty
syntax region asemeComment_197 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_194,asemeComment_197 skipwhite skipempty
syntax match asemeComment_197 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_194,asemeComment_197 skipwhite skipempty
syntax match asemeClause_194 /\von%(<|>)/ contained nextgroup=asemeReference_192,asemeComment_195 skipwhite skipempty
syntax region asemeComment_195 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_192,asemeComment_195 skipwhite skipempty
syntax match asemeComment_195 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_192,asemeComment_195 skipwhite skipempty
syntax match asemeReference_192 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax region asemeComment_193 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax match asemeComment_193 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_193 skipwhite skipempty
syntax match asemeDeclaration_190 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_188,asemeComment_191 skipwhite skipempty
syntax region asemeComment_191 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_188,asemeComment_191 skipwhite skipempty
syntax match asemeComment_191 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_188,asemeComment_191 skipwhite skipempty
syntax match asemeName_188 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_187,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_187,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_187,asemeComment_189 skipwhite skipempty
syntax match asemePunctuation_187 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_160,asemePunctuation_168,asemePunctuation_174,asemeOperator_177,asemePunctuation_179,asemeBuiltIn_181,asemeType_183,asemeName_185
syntax match asemeName_185 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_184,asemeComment_186 skipwhite skipempty
syntax region asemeComment_186 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_184,asemeComment_186 skipwhite skipempty
syntax match asemeComment_186 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_184,asemeComment_186 skipwhite skipempty
syntax match asemePunctuation_184 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemeType_183 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_180,asemeComment_182 skipwhite skipempty
syntax match asemeBuiltIn_181 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_180,asemeComment_182 skipwhite skipempty
syntax region asemeComment_182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_180,asemeComment_182 skipwhite skipempty
syntax match asemeComment_182 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_180,asemeComment_182 skipwhite skipempty
syntax match asemeName_180 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemePunctuation_179 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemeOperator_177 /\v\=%(\=)@!/ contained nextgroup=asemeText_176,asemeComment_178 skipwhite skipempty
syntax region asemeComment_178 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_176,asemeComment_178 skipwhite skipempty
syntax match asemeComment_178 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_176,asemeComment_178 skipwhite skipempty
syntax match asemeText_176 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemePunctuation_174 /\v\,/ contained nextgroup=asemeBuiltIn_171,asemeType_173,asemeComment_175 skipwhite skipempty
syntax region asemeComment_175 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_171,asemeType_173,asemeComment_175 skipwhite skipempty
syntax match asemeComment_175 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_171,asemeType_173,asemeComment_175 skipwhite skipempty
syntax match asemeType_173 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_170,asemeComment_172 skipwhite skipempty
syntax match asemeBuiltIn_171 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_170,asemeComment_172 skipwhite skipempty
syntax region asemeComment_172 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_170,asemeComment_172 skipwhite skipempty
syntax match asemeComment_172 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_170,asemeComment_172 skipwhite skipempty
syntax match asemeName_170 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemePunctuation_168 /\v\:/ contained nextgroup=asemeBuiltIn_165,asemeType_167,asemeComment_169 skipwhite skipempty
syntax region asemeComment_169 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_165,asemeType_167,asemeComment_169 skipwhite skipempty
syntax match asemeComment_169 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_165,asemeType_167,asemeComment_169 skipwhite skipempty
syntax match asemeType_167 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_163,asemeComment_166 skipwhite skipempty
syntax match asemeBuiltIn_165 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_163,asemeComment_166 skipwhite skipempty
syntax region asemeComment_166 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_163,asemeComment_166 skipwhite skipempty
syntax match asemeComment_166 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_163,asemeComment_166 skipwhite skipempty
syntax match asemeOperator_163 /\v\=%(\=)@!/ contained nextgroup=asemeText_162,asemeComment_164 skipwhite skipempty
syntax region asemeComment_164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_162,asemeComment_164 skipwhite skipempty
syntax match asemeComment_164 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_162,asemeComment_164 skipwhite skipempty
syntax match asemeText_162 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemePunctuation_160 /\v\)/ contained nextgroup=asemePunctuation_158,asemeComment_161 skipwhite skipempty
syntax region asemeComment_161 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_158,asemeComment_161 skipwhite skipempty
syntax match asemeComment_161 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_158,asemeComment_161 skipwhite skipempty
syntax match asemePunctuation_158 /\v\:/ contained nextgroup=asemeBuiltIn_155,asemeType_157,asemeComment_159 skipwhite skipempty
syntax region asemeComment_159 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_155,asemeType_157,asemeComment_159 skipwhite skipempty
syntax match asemeComment_159 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_155,asemeType_157,asemeComment_159 skipwhite skipempty
syntax match asemeType_157 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_153,asemeComment_156 skipwhite skipempty
syntax match asemeBuiltIn_155 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_153,asemeComment_156 skipwhite skipempty
syntax region asemeComment_156 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_153,asemeComment_156 skipwhite skipempty
syntax match asemeComment_156 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_153,asemeComment_156 skipwhite skipempty
syntax match asemeOperator_153 /\v\=%(\=)@!/ contained nextgroup=asemeText_151,asemeComment_154 skipwhite skipempty
syntax region asemeComment_154 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_151,asemeComment_154 skipwhite skipempty
syntax match asemeComment_154 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_151,asemeComment_154 skipwhite skipempty
syntax match asemeText_151 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax region asemeComment_152 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemeComment_152 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_152 skipwhite skipempty
syntax match asemeDeclaration_149 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_148,asemeComment_150 skipwhite skipempty
syntax region asemeComment_150 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_148,asemeComment_150 skipwhite skipempty
syntax match asemeComment_150 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_148,asemeComment_150 skipwhite skipempty
syntax match asemeBlock_148 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_119,asemeClause_122,asemeClause_125,asemePunctuation_146,asemeBlock_147
syntax match asemeBlock_147 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax region asemePunctuation_146 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_144,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeDeclaration_144 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_143,asemeComment_145 skipwhite skipempty
syntax region asemeComment_145 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_143,asemeComment_145 skipwhite skipempty
syntax match asemeComment_145 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_143,asemeComment_145 skipwhite skipempty
syntax match asemeReference_143 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_129,asemeClause_132,asemeClause_135,asemeChoice_137,asemePunctuation_140,asemeReference_142
syntax match asemeReference_142 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemePunctuation_140 /\v\,/ contained nextgroup=asemeReference_138,asemeReference_139,asemeComment_141 skipwhite skipempty
syntax region asemeComment_141 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_138,asemeReference_139,asemeComment_141 skipwhite skipempty
syntax match asemeComment_141 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_138,asemeReference_139,asemeComment_141 skipwhite skipempty
syntax match asemeReference_139 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeReference_138 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeChoice_137 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeClause_135 /\vexpires%(<|>)/ contained nextgroup=asemeNumber_134,asemeComment_136 skipwhite skipempty
syntax region asemeComment_136 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_134,asemeComment_136 skipwhite skipempty
syntax match asemeComment_136 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_134,asemeComment_136 skipwhite skipempty
syntax match asemeNumber_134 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeClause_132 /\vevery%(<|>)/ contained nextgroup=asemeNumber_131,asemeComment_133 skipwhite skipempty
syntax region asemeComment_133 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_131,asemeComment_133 skipwhite skipempty
syntax match asemeComment_133 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_131,asemeComment_133 skipwhite skipempty
syntax match asemeNumber_131 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeClause_129 /\vfrom%(<|>)/ contained nextgroup=asemeReference_127,asemeComment_130 skipwhite skipempty
syntax region asemeComment_130 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_127,asemeComment_130 skipwhite skipempty
syntax match asemeComment_130 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_127,asemeComment_130 skipwhite skipempty
syntax match asemeReference_127 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax region asemeComment_128 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeComment_128 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_128 skipwhite skipempty
syntax match asemeClause_125 /\vdelay%(<|>)/ contained nextgroup=asemeNumber_124,asemeComment_126 skipwhite skipempty
syntax region asemeComment_126 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_124,asemeComment_126 skipwhite skipempty
syntax match asemeComment_126 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_124,asemeComment_126 skipwhite skipempty
syntax match asemeNumber_124 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax match asemeClause_122 /\vradio%(<|>)/ contained nextgroup=asemeNumber_121,asemeComment_123 skipwhite skipempty
syntax region asemeComment_123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_121,asemeComment_123 skipwhite skipempty
syntax match asemeComment_123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_121,asemeComment_123 skipwhite skipempty
syntax match asemeNumber_121 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax match asemeClause_119 /\vunder%(<|>)/ contained nextgroup=asemeReference_117,asemeComment_120 skipwhite skipempty
syntax region asemeComment_120 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_117,asemeComment_120 skipwhite skipempty
syntax match asemeComment_120 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_117,asemeComment_120 skipwhite skipempty
syntax match asemeReference_117 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax region asemeComment_118 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax match asemeComment_118 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_118 skipwhite skipempty
syntax match asemeDeclaration_115 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_114,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_114,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_114,asemeComment_116 skipwhite skipempty
syntax match asemeBlock_114 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_113 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_111,asemeBlock_112
syntax match asemeBlock_112 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_113 skipwhite skipempty
syntax region asemeComment_113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_113 skipwhite skipempty
syntax match asemeComment_113 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_113 skipwhite skipempty
syntax region asemePunctuation_111 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_105,asemeBuiltIn_108,asemeType_110,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeType_110 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_107,asemeComment_109 skipwhite skipempty
syntax match asemeBuiltIn_108 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_107,asemeComment_109 skipwhite skipempty
syntax region asemeComment_109 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_107,asemeComment_109 skipwhite skipempty
syntax match asemeComment_109 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_107,asemeComment_109 skipwhite skipempty
syntax match asemeName_107 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax match asemeDeclaration_105 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_102,asemeType_104,asemeComment_106 skipwhite skipempty
syntax region asemeComment_106 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_102,asemeType_104,asemeComment_106 skipwhite skipempty
syntax match asemeComment_106 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_102,asemeType_104,asemeComment_106 skipwhite skipempty
syntax match asemeType_104 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_101,asemeComment_103 skipwhite skipempty
syntax match asemeBuiltIn_102 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_101,asemeComment_103 skipwhite skipempty
syntax region asemeComment_103 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_101,asemeComment_103 skipwhite skipempty
syntax match asemeComment_103 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_101,asemeComment_103 skipwhite skipempty
syntax match asemeName_101 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_93,asemePunctuation_95,asemeBuiltIn_97,asemeType_99,asemeName_100
syntax match asemeName_100 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax match asemeType_99 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax match asemeBuiltIn_97 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax region asemeComment_98 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax match asemeComment_98 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_96,asemeComment_98 skipwhite skipempty
syntax match asemeName_96 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax match asemePunctuation_95 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax match asemeOperator_93 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_91,asemeComment_94 skipwhite skipempty
syntax region asemeComment_94 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_91,asemeComment_94 skipwhite skipempty
syntax match asemeComment_94 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_91,asemeComment_94 skipwhite skipempty
syntax match asemeNumber_91 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax region asemeComment_92 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax match asemeComment_92 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_92 skipwhite skipempty
syntax match asemeDeclaration_89 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_88,asemeComment_90 skipwhite skipempty
syntax region asemeComment_90 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_88,asemeComment_90 skipwhite skipempty
syntax match asemeComment_90 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_88,asemeComment_90 skipwhite skipempty
syntax match asemeBlock_88 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_87 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_85,asemeBlock_86
syntax match asemeBlock_86 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_87 skipwhite skipempty
syntax region asemeComment_87 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_87 skipwhite skipempty
syntax match asemeComment_87 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_87 skipwhite skipempty
syntax region asemePunctuation_85 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_84,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemeName_84 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_80 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_81,asemePunctuation_83
syntax match asemePunctuation_83 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_80 skipwhite skipempty
syntax match asemeOperator_81 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_79,asemeComment_82 skipwhite skipempty
syntax region asemeComment_82 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_79,asemeComment_82 skipwhite skipempty
syntax match asemeComment_82 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_79,asemeComment_82 skipwhite skipempty
syntax match asemeNumber_79 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_80 skipwhite skipempty
syntax region asemeComment_80 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_80 skipwhite skipempty
syntax match asemeComment_80 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_80 skipwhite skipempty
syntax match asemeDeclaration_77 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_75,asemeComment_78 skipwhite skipempty
syntax region asemeComment_78 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_75,asemeComment_78 skipwhite skipempty
syntax match asemeComment_78 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_75,asemeComment_78 skipwhite skipempty
syntax match asemeName_75 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_74,asemeComment_76 skipwhite skipempty
syntax region asemeComment_76 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_74,asemeComment_76 skipwhite skipempty
syntax match asemeComment_76 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_74,asemeComment_76 skipwhite skipempty
syntax match asemeOperator_74 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_1251,asemeClause_1254,asemeText_1256,asemeNumber_1257,asemeTruth_1258,asemeLogic_1259,asemeClause_1260,asemeClause_1261,asemeClause_1262,asemeClause_1263,asemeClause_1264,asemeClause_1265,asemeClause_1266,asemeClause_1267,asemeClause_1268,asemeClause_1269,asemeClause_1270,asemeClause_1271,asemeClause_1272,asemeClause_1273,asemeCall_1274,asemeReference_1275,asemeOperator_1276,asemePunctuation_1277
syntax match asemePunctuation_1277 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeOperator_1276 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeReference_1275 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeCall_1274 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1273 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1272 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1271 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1270 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1269 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1268 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1267 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1266 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1265 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1264 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1263 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1262 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1261 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1260 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeLogic_1259 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeTruth_1258 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeNumber_1257 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeText_1256 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeClause_1254 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1253,asemeComment_1255 skipwhite skipempty
syntax region asemeComment_1255 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1253,asemeComment_1255 skipwhite skipempty
syntax match asemeComment_1255 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1253,asemeComment_1255 skipwhite skipempty
syntax match asemeReference_1253 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1246,asemeComment_1248 skipwhite skipempty
syntax match asemeClause_1251 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1249,asemeComment_1252 skipwhite skipempty
syntax region asemeComment_1252 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1249,asemeComment_1252 skipwhite skipempty
syntax match asemeComment_1252 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1249,asemeComment_1252 skipwhite skipempty
syntax match asemeReference_1249 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1247,asemeComment_1250 skipwhite skipempty
syntax region asemeComment_1250 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1247,asemeComment_1250 skipwhite skipempty
syntax match asemeComment_1250 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1247,asemeComment_1250 skipwhite skipempty
syntax match asemeReference_1247 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1246,asemeComment_1248 skipwhite skipempty
syntax region asemeComment_1248 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1246,asemeComment_1248 skipwhite skipempty
syntax match asemeComment_1248 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1246,asemeComment_1248 skipwhite skipempty
syntax region asemePunctuation_1246 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax region asemeComment_1245 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax match asemeComment_1245 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1245 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_1198,asemeClause_1201,asemeText_1203,asemeNumber_1204,asemeTruth_1205,asemeLogic_1206,asemeClause_1207,asemeClause_1208,asemeClause_1209,asemeClause_1210,asemeClause_1211,asemeClause_1212,asemeClause_1213,asemeClause_1214,asemeClause_1215,asemeClause_1216,asemeClause_1217,asemeClause_1218,asemeClause_1219,asemeClause_1220,asemeCall_1221,asemeReference_1222,asemeOperator_1223,asemePunctuation_1224
syntax match asemePunctuation_1224 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeOperator_1223 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeReference_1222 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeCall_1221 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1220 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1219 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1218 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1217 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1216 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1215 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1214 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1213 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1212 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1211 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1210 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1209 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1208 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1207 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeLogic_1206 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeTruth_1205 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeNumber_1204 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeText_1203 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeClause_1201 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1200,asemeComment_1202 skipwhite skipempty
syntax region asemeComment_1202 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1200,asemeComment_1202 skipwhite skipempty
syntax match asemeComment_1202 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1200,asemeComment_1202 skipwhite skipempty
syntax match asemeReference_1200 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1193,asemeComment_1195 skipwhite skipempty
syntax match asemeClause_1198 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1196,asemeComment_1199 skipwhite skipempty
syntax region asemeComment_1199 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1196,asemeComment_1199 skipwhite skipempty
syntax match asemeComment_1199 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1196,asemeComment_1199 skipwhite skipempty
syntax match asemeReference_1196 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1194,asemeComment_1197 skipwhite skipempty
syntax region asemeComment_1197 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1194,asemeComment_1197 skipwhite skipempty
syntax match asemeComment_1197 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1194,asemeComment_1197 skipwhite skipempty
syntax match asemeReference_1194 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1193,asemeComment_1195 skipwhite skipempty
syntax region asemeComment_1195 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1193,asemeComment_1195 skipwhite skipempty
syntax match asemeComment_1195 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1193,asemeComment_1195 skipwhite skipempty
syntax region asemePunctuation_1193 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax region asemeComment_1192 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax match asemeComment_1192 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1192 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_1135,asemeClause_1138,asemeText_1140,asemeNumber_1141,asemeTruth_1142,asemeLogic_1143,asemeClause_1144,asemeClause_1145,asemeClause_1146,asemeClause_1147,asemeClause_1148,asemeClause_1149,asemeClause_1150,asemeClause_1151,asemeClause_1152,asemeClause_1153,asemeClause_1154,asemeClause_1155,asemeClause_1156,asemeClause_1157,asemeCall_1158,asemeReference_1159,asemeOperator_1160,asemePunctuation_1161
syntax match asemePunctuation_1161 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeOperator_1160 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeReference_1159 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeCall_1158 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1157 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1156 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1155 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1154 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1153 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1152 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1151 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1150 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1149 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1148 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1147 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1146 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1145 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1144 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeLogic_1143 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeTruth_1142 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeNumber_1141 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeText_1140 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeClause_1138 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1137,asemeComment_1139 skipwhite skipempty
syntax region asemeComment_1139 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1137,asemeComment_1139 skipwhite skipempty
syntax match asemeComment_1139 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1137,asemeComment_1139 skipwhite skipempty
syntax match asemeReference_1137 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1130,asemeComment_1132 skipwhite skipempty
syntax match asemeClause_1135 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1133,asemeComment_1136 skipwhite skipempty
syntax region asemeComment_1136 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1133,asemeComment_1136 skipwhite skipempty
syntax match asemeComment_1136 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1133,asemeComment_1136 skipwhite skipempty
syntax match asemeReference_1133 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1131,asemeComment_1134 skipwhite skipempty
syntax region asemeComment_1134 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1131,asemeComment_1134 skipwhite skipempty
syntax match asemeComment_1134 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1131,asemeComment_1134 skipwhite skipempty
syntax match asemeReference_1131 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1130,asemeComment_1132 skipwhite skipempty
syntax region asemeComment_1132 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1130,asemeComment_1132 skipwhite skipempty
syntax match asemeComment_1132 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1130,asemeComment_1132 skipwhite skipempty
syntax region asemePunctuation_1130 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax region asemeComment_1129 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax match asemeComment_1129 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1129 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_926,asemeNumber_928,asemeReference_929,asemeNumber_930,asemeOperator_931,asemePunctuation_932
syntax match asemePunctuation_932 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemeOperator_931 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemeNumber_930 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemeReference_929 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemeNumber_928 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemeText_926 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax region asemeComment_927 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax match asemeComment_927 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_927 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_877,asemeClause_880,asemeText_882,asemeNumber_883,asemeTruth_884,asemeLogic_885,asemeClause_886,asemeClause_887,asemeClause_888,asemeClause_889,asemeClause_890,asemeClause_891,asemeClause_892,asemeClause_893,asemeClause_894,asemeClause_895,asemeClause_896,asemeClause_897,asemeClause_898,asemeClause_899,asemeCall_900,asemeReference_901,asemeOperator_902,asemePunctuation_903
syntax match asemePunctuation_903 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeOperator_902 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeReference_901 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeCall_900 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_899 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_898 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_897 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_896 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_895 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_894 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_893 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_892 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_891 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_890 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_889 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_888 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_887 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_886 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeLogic_885 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeTruth_884 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeNumber_883 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeText_882 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeClause_880 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_879,asemeComment_881 skipwhite skipempty
syntax region asemeComment_881 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_879,asemeComment_881 skipwhite skipempty
syntax match asemeComment_881 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_879,asemeComment_881 skipwhite skipempty
syntax match asemeReference_879 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_872,asemeComment_874 skipwhite skipempty
syntax match asemeClause_877 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_875,asemeComment_878 skipwhite skipempty
syntax region asemeComment_878 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_875,asemeComment_878 skipwhite skipempty
syntax match asemeComment_878 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_875,asemeComment_878 skipwhite skipempty
syntax match asemeReference_875 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_873,asemeComment_876 skipwhite skipempty
syntax region asemeComment_876 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_873,asemeComment_876 skipwhite skipempty
syntax match asemeComment_876 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_873,asemeComment_876 skipwhite skipempty
syntax match asemeReference_873 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_872,asemeComment_874 skipwhite skipempty
syntax region asemeComment_874 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_872,asemeComment_874 skipwhite skipempty
syntax match asemeComment_874 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_872,asemeComment_874 skipwhite skipempty
syntax region asemePunctuation_872 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax region asemeComment_871 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax match asemeComment_871 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_871 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfSrm contains=asemeReference_775,asemeText_777,asemeNumber_778,asemeTruth_779,asemeLogic_780,asemeClause_781,asemeClause_782,asemeClause_783,asemeClause_784,asemeClause_785,asemeClause_786,asemeClause_787,asemeClause_788,asemeClause_789,asemeClause_790,asemeClause_791,asemeClause_792,asemeClause_793,asemeClause_794,asemeCall_795,asemeReference_796,asemeOperator_797,asemePunctuation_798
syntax match asemePunctuation_798 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeOperator_797 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeReference_796 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeCall_795 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_794 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_793 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_792 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_791 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_790 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_789 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_788 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_787 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_786 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_785 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_784 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_783 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_782 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeClause_781 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeLogic_780 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeTruth_779 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeNumber_778 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeText_777 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeReference_775 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_773,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_773,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_773,asemeComment_776 skipwhite skipempty
syntax match asemeReference_773 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_772,asemeComment_774 skipwhite skipempty
syntax region asemeComment_774 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_772,asemeComment_774 skipwhite skipempty
syntax match asemeComment_774 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_772,asemeComment_774 skipwhite skipempty
syntax region asemePunctuation_772 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax region asemeComment_771 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax match asemeComment_771 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_771 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfSrm contains=asemeClause_735,asemeClause_738,asemeText_740,asemeNumber_741,asemeTruth_742,asemeLogic_743,asemeClause_744,asemeClause_745,asemeClause_746,asemeClause_747,asemeClause_748,asemeClause_749,asemeClause_750,asemeClause_751,asemeClause_752,asemeClause_753,asemeClause_754,asemeClause_755,asemeClause_756,asemeClause_757,asemeCall_758,asemeReference_759,asemeOperator_760,asemePunctuation_761
syntax match asemePunctuation_761 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeOperator_760 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeReference_759 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeCall_758 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_757 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_756 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_755 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_754 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_753 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_752 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_751 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_750 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_749 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_748 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_747 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_746 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_745 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_744 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeLogic_743 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeTruth_742 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeNumber_741 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeText_740 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeClause_738 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_737,asemeComment_739 skipwhite skipempty
syntax region asemeComment_739 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_737,asemeComment_739 skipwhite skipempty
syntax match asemeComment_739 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_737,asemeComment_739 skipwhite skipempty
syntax match asemeReference_737 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_730,asemeComment_732 skipwhite skipempty
syntax match asemeClause_735 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_733,asemeComment_736 skipwhite skipempty
syntax region asemeComment_736 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_733,asemeComment_736 skipwhite skipempty
syntax match asemeComment_736 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_733,asemeComment_736 skipwhite skipempty
syntax match asemeReference_733 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_731,asemeComment_734 skipwhite skipempty
syntax region asemeComment_734 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_731,asemeComment_734 skipwhite skipempty
syntax match asemeComment_734 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_731,asemeComment_734 skipwhite skipempty
syntax match asemeReference_731 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_730,asemeComment_732 skipwhite skipempty
syntax region asemeComment_732 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_730,asemeComment_732 skipwhite skipempty
syntax match asemeComment_732 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_730,asemeComment_732 skipwhite skipempty
syntax region asemePunctuation_730 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax region asemeComment_729 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax match asemeComment_729 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_729 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_661,asemeClause_664,asemeText_666,asemeNumber_667,asemeTruth_668,asemeLogic_669,asemeClause_670,asemeClause_671,asemeClause_672,asemeClause_673,asemeClause_674,asemeClause_675,asemeClause_676,asemeClause_677,asemeClause_678,asemeClause_679,asemeClause_680,asemeClause_681,asemeClause_682,asemeClause_683,asemeCall_684,asemeReference_685,asemeOperator_686,asemePunctuation_687
syntax match asemePunctuation_687 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeOperator_686 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeReference_685 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeCall_684 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_683 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_682 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_681 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_680 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_679 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_678 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_677 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_676 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_675 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_674 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_673 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_672 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_671 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_670 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeLogic_669 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeTruth_668 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeNumber_667 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeText_666 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeClause_664 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_663,asemeComment_665 skipwhite skipempty
syntax region asemeComment_665 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_663,asemeComment_665 skipwhite skipempty
syntax match asemeComment_665 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_663,asemeComment_665 skipwhite skipempty
syntax match asemeReference_663 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_656,asemeComment_658 skipwhite skipempty
syntax match asemeClause_661 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_659,asemeComment_662 skipwhite skipempty
syntax region asemeComment_662 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_659,asemeComment_662 skipwhite skipempty
syntax match asemeComment_662 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_659,asemeComment_662 skipwhite skipempty
syntax match asemeReference_659 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_657,asemeComment_660 skipwhite skipempty
syntax region asemeComment_660 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_657,asemeComment_660 skipwhite skipempty
syntax match asemeComment_660 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_657,asemeComment_660 skipwhite skipempty
syntax match asemeReference_657 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_656,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_656,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_656,asemeComment_658 skipwhite skipempty
syntax region asemePunctuation_656 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax region asemeComment_655 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax match asemeComment_655 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_655 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_620,asemeClause_623,asemeText_625,asemeNumber_626,asemeTruth_627,asemeLogic_628,asemeClause_629,asemeClause_630,asemeClause_631,asemeClause_632,asemeClause_633,asemeClause_634,asemeClause_635,asemeClause_636,asemeClause_637,asemeClause_638,asemeClause_639,asemeClause_640,asemeClause_641,asemeClause_642,asemeCall_643,asemeReference_644,asemeOperator_645,asemePunctuation_646
syntax match asemePunctuation_646 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeOperator_645 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeReference_644 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeCall_643 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_642 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_641 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_640 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_639 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_638 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_637 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_636 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_635 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_634 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_633 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_632 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_631 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_630 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_629 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeLogic_628 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeTruth_627 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeNumber_626 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeText_625 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeClause_623 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_622,asemeComment_624 skipwhite skipempty
syntax region asemeComment_624 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_622,asemeComment_624 skipwhite skipempty
syntax match asemeComment_624 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_622,asemeComment_624 skipwhite skipempty
syntax match asemeReference_622 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_615,asemeComment_617 skipwhite skipempty
syntax match asemeClause_620 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_618,asemeComment_621 skipwhite skipempty
syntax region asemeComment_621 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_618,asemeComment_621 skipwhite skipempty
syntax match asemeComment_621 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_618,asemeComment_621 skipwhite skipempty
syntax match asemeReference_618 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_616,asemeComment_619 skipwhite skipempty
syntax region asemeComment_619 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_616,asemeComment_619 skipwhite skipempty
syntax match asemeComment_619 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_616,asemeComment_619 skipwhite skipempty
syntax match asemeReference_616 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_615,asemeComment_617 skipwhite skipempty
syntax region asemeComment_617 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_615,asemeComment_617 skipwhite skipempty
syntax match asemeComment_617 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_615,asemeComment_617 skipwhite skipempty
syntax region asemePunctuation_615 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax region asemeComment_614 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax match asemeComment_614 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_614 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_549,asemeNumber_551,asemeReference_552,asemeNumber_553,asemeOperator_554,asemePunctuation_555
syntax match asemePunctuation_555 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemeOperator_554 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemeNumber_553 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemeReference_552 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemeNumber_551 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemeText_549 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_550 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant contains=asemeClause_453,asemeClause_456,asemeText_458,asemeNumber_459,asemeTruth_460,asemeLogic_461,asemeClause_462,asemeClause_463,asemeClause_464,asemeClause_465,asemeClause_466,asemeClause_467,asemeClause_468,asemeClause_469,asemeClause_470,asemeClause_471,asemeClause_472,asemeClause_473,asemeClause_474,asemeClause_475,asemeCall_476,asemeReference_477,asemeOperator_478,asemePunctuation_479
syntax match asemePunctuation_479 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeOperator_478 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeReference_477 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeCall_476 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_475 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_474 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_473 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_472 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_471 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_470 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_469 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_468 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_467 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_466 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_465 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_464 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_463 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_462 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeLogic_461 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeTruth_460 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeNumber_459 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeText_458 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeClause_456 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_455,asemeComment_457 skipwhite skipempty
syntax region asemeComment_457 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_455,asemeComment_457 skipwhite skipempty
syntax match asemeComment_457 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_455,asemeComment_457 skipwhite skipempty
syntax match asemeReference_455 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_448,asemeComment_450 skipwhite skipempty
syntax match asemeClause_453 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_451,asemeComment_454 skipwhite skipempty
syntax region asemeComment_454 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_451,asemeComment_454 skipwhite skipempty
syntax match asemeComment_454 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_451,asemeComment_454 skipwhite skipempty
syntax match asemeReference_451 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_449,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_449,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_449,asemeComment_452 skipwhite skipempty
syntax match asemeReference_449 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_448,asemeComment_450 skipwhite skipempty
syntax region asemeComment_450 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_448,asemeComment_450 skipwhite skipempty
syntax match asemeComment_450 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_448,asemeComment_450 skipwhite skipempty
syntax region asemePunctuation_448 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax region asemeComment_447 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax match asemeComment_447 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_447 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_394,asemeClause_397,asemeText_399,asemeNumber_400,asemeTruth_401,asemeLogic_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeClause_406,asemeClause_407,asemeClause_408,asemeClause_409,asemeClause_410,asemeClause_411,asemeClause_412,asemeClause_413,asemeClause_414,asemeClause_415,asemeClause_416,asemeCall_417,asemeReference_418,asemeOperator_419,asemePunctuation_420
syntax match asemePunctuation_420 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeOperator_419 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeReference_418 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeCall_417 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_416 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_415 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_414 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_413 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_412 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_411 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_410 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_409 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_408 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_407 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_406 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeLogic_402 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeTruth_401 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeNumber_400 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeText_399 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
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
syntax region asemePunctuation_389 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax region asemeComment_388 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax match asemeComment_388 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_388 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeReference_308,asemeText_310,asemeNumber_311,asemeTruth_312,asemeLogic_313,asemeClause_314,asemeClause_315,asemeClause_316,asemeClause_317,asemeClause_318,asemeClause_319,asemeClause_320,asemeClause_321,asemeClause_322,asemeClause_323,asemeClause_324,asemeClause_325,asemeClause_326,asemeClause_327,asemeCall_328,asemeReference_329,asemeOperator_330,asemePunctuation_331
syntax match asemePunctuation_331 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeOperator_330 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeReference_329 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeCall_328 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_327 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_326 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_325 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_324 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_323 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_322 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_321 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_320 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_319 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_318 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_317 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_316 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_315 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeClause_314 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeLogic_313 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeTruth_312 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeNumber_311 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeText_310 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeReference_308 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_306,asemeComment_309 skipwhite skipempty
syntax region asemeComment_309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_306,asemeComment_309 skipwhite skipempty
syntax match asemeComment_309 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_306,asemeComment_309 skipwhite skipempty
syntax match asemeReference_306 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_305,asemeComment_307 skipwhite skipempty
syntax region asemeComment_307 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_305,asemeComment_307 skipwhite skipempty
syntax match asemeComment_307 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_305,asemeComment_307 skipwhite skipempty
syntax region asemePunctuation_305 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax region asemeComment_304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax match asemeComment_304 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_304 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeClause_268,asemeClause_271,asemeText_273,asemeNumber_274,asemeTruth_275,asemeLogic_276,asemeClause_277,asemeClause_278,asemeClause_279,asemeClause_280,asemeClause_281,asemeClause_282,asemeClause_283,asemeClause_284,asemeClause_285,asemeClause_286,asemeClause_287,asemeClause_288,asemeClause_289,asemeClause_290,asemeCall_291,asemeReference_292,asemeOperator_293,asemePunctuation_294
syntax match asemePunctuation_294 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeOperator_293 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeReference_292 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeCall_291 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_290 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_289 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_288 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_287 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_286 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_285 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_284 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_283 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_282 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_281 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_280 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_279 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_278 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_277 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeLogic_276 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeTruth_275 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeNumber_274 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeText_273 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeClause_271 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_270,asemeComment_272 skipwhite skipempty
syntax region asemeComment_272 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_270,asemeComment_272 skipwhite skipempty
syntax match asemeComment_272 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_270,asemeComment_272 skipwhite skipempty
syntax match asemeReference_270 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_263,asemeComment_265 skipwhite skipempty
syntax match asemeClause_268 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_266,asemeComment_269 skipwhite skipempty
syntax region asemeComment_269 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_266,asemeComment_269 skipwhite skipempty
syntax match asemeComment_269 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_266,asemeComment_269 skipwhite skipempty
syntax match asemeReference_266 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_264,asemeComment_267 skipwhite skipempty
syntax region asemeComment_267 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_264,asemeComment_267 skipwhite skipempty
syntax match asemeComment_267 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_264,asemeComment_267 skipwhite skipempty
syntax match asemeReference_264 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_263,asemeComment_265 skipwhite skipempty
syntax region asemeComment_265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_263,asemeComment_265 skipwhite skipempty
syntax match asemeComment_265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_263,asemeComment_265 skipwhite skipempty
syntax region asemePunctuation_263 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax region asemeComment_262 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax match asemeComment_262 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_262 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_47,asemeClause_50,asemeText_52,asemeNumber_53,asemeTruth_54,asemeLogic_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeClause_59,asemeClause_60,asemeClause_61,asemeClause_62,asemeClause_63,asemeClause_64,asemeClause_65,asemeClause_66,asemeClause_67,asemeClause_68,asemeClause_69,asemeCall_70,asemeReference_71,asemeOperator_72,asemePunctuation_73
syntax match asemePunctuation_73 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeOperator_72 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeReference_71 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeCall_70 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_69 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_68 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_67 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_66 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_65 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_64 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_63 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeLogic_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeTruth_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeNumber_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeText_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeClause_50 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_49,asemeComment_51 skipwhite skipempty
syntax region asemeComment_51 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_49,asemeComment_51 skipwhite skipempty
syntax match asemeComment_51 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_49,asemeComment_51 skipwhite skipempty
syntax match asemeReference_49 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_42,asemeComment_44 skipwhite skipempty
syntax match asemeClause_47 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_45,asemeComment_48 skipwhite skipempty
syntax region asemeComment_48 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_45,asemeComment_48 skipwhite skipempty
syntax match asemeComment_48 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_45,asemeComment_48 skipwhite skipempty
syntax match asemeReference_45 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_43,asemeComment_46 skipwhite skipempty
syntax region asemeComment_46 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_43,asemeComment_46 skipwhite skipempty
syntax match asemeComment_46 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_43,asemeComment_46 skipwhite skipempty
syntax match asemeReference_43 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_42,asemeComment_44 skipwhite skipempty
syntax region asemeComment_44 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_42,asemeComment_44 skipwhite skipempty
syntax match asemeComment_44 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_42,asemeComment_44 skipwhite skipempty
syntax region asemePunctuation_42 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax region asemeComment_41 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax match asemeComment_41 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_41 skipwhite skipempty
syntax cluster asemeContentOfAMessage contains=asemeText_13,asemeNumber_14,asemeTruth_15,asemeLogic_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeClause_23,asemeClause_24,asemeClause_25,asemeClause_26,asemeClause_27,asemeClause_28,asemeClause_29,asemeClause_30,asemeCall_31,asemeReference_32,asemeOperator_33,asemePunctuation_34,asemeText_35,asemeText_36,asemeNumber_37,asemeReference_38,asemeReference_39,asemePunctuation_40,asemeComment
syntax match asemePunctuation_34 /\v%([^ \t{}])@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_33 /\v%([^ \t{}])@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_32 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeCall_31 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained
syntax match asemeClause_30 /\v%([^ \t{}])@=write_messages%(<|>)%(\_s*\.)@=/ contained
syntax match asemeClause_29 /\v%([^ \t{}])@=read_messages%(<|>)%(\_s*\()@!/ contained
syntax match asemeClause_28 /\v%([^ \t{}])@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_27 /\v%([^ \t{}])@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_26 /\v%([^ \t{}])@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_25 /\v%([^ \t{}])@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained
syntax match asemeClause_24 /\v%([^ \t{}])@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_23 /\v%([^ \t{}])@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_22 /\v%([^ \t{}])@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_21 /\v%([^ \t{}])@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained
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
highlight default link asemeBlock_1064 asemeBlock
highlight default link asemeBlock_1066 asemeBlock
highlight default link asemeBlock_1078 asemeBlock
highlight default link asemeBlock_1084 asemeBlock
highlight default link asemeBlock_1089 asemeBlock
highlight default link asemeBlock_1090 asemeBlock
highlight default link asemeBlock_1095 asemeBlock
highlight default link asemeBlock_112 asemeBlock
highlight default link asemeBlock_114 asemeBlock
highlight default link asemeBlock_1240 asemeBlock
highlight default link asemeBlock_1242 asemeBlock
highlight default link asemeBlock_1311 asemeBlock
highlight default link asemeBlock_1313 asemeBlock
highlight default link asemeBlock_147 asemeBlock
highlight default link asemeBlock_148 asemeBlock
highlight default link asemeBlock_210 asemeBlock
highlight default link asemeBlock_212 asemeBlock
highlight default link asemeBlock_559 asemeBlock
highlight default link asemeBlock_560 asemeBlock
highlight default link asemeBlock_701 asemeBlock
highlight default link asemeBlock_707 asemeBlock
highlight default link asemeBlock_712 asemeBlock
highlight default link asemeBlock_714 asemeBlock
highlight default link asemeBlock_717 asemeBlock
highlight default link asemeBlock_86 asemeBlock
highlight default link asemeBlock_88 asemeBlock
highlight default link asemeBuiltIn_102 asemeBuiltIn
highlight default link asemeBuiltIn_108 asemeBuiltIn
highlight default link asemeBuiltIn_1167 asemeBuiltIn
highlight default link asemeBuiltIn_1184 asemeBuiltIn
highlight default link asemeBuiltIn_155 asemeBuiltIn
highlight default link asemeBuiltIn_165 asemeBuiltIn
highlight default link asemeBuiltIn_171 asemeBuiltIn
highlight default link asemeBuiltIn_181 asemeBuiltIn
highlight default link asemeBuiltIn_363 asemeBuiltIn
highlight default link asemeBuiltIn_380 asemeBuiltIn
highlight default link asemeBuiltIn_426 asemeBuiltIn
highlight default link asemeBuiltIn_443 asemeBuiltIn
highlight default link asemeBuiltIn_481 asemeBuiltIn
highlight default link asemeBuiltIn_487 asemeBuiltIn
highlight default link asemeBuiltIn_489 asemeBuiltIn
highlight default link asemeBuiltIn_541 asemeBuiltIn
highlight default link asemeBuiltIn_846 asemeBuiltIn
highlight default link asemeBuiltIn_863 asemeBuiltIn
highlight default link asemeBuiltIn_918 asemeBuiltIn
highlight default link asemeBuiltIn_97 asemeBuiltIn
highlight default link asemeBuiltIn_975 asemeBuiltIn
highlight default link asemeBuiltIn_983 asemeBuiltIn
highlight default link asemeBuiltIn_997 asemeBuiltIn
highlight default link asemeCall_1158 asemeCall
highlight default link asemeCall_1221 asemeCall
highlight default link asemeCall_1274 asemeCall
highlight default link asemeCall_291 asemeCall
highlight default link asemeCall_31 asemeCall
highlight default link asemeCall_328 asemeCall
highlight default link asemeCall_417 asemeCall
highlight default link asemeCall_476 asemeCall
highlight default link asemeCall_643 asemeCall
highlight default link asemeCall_684 asemeCall
highlight default link asemeCall_70 asemeCall
highlight default link asemeCall_758 asemeCall
highlight default link asemeCall_795 asemeCall
highlight default link asemeCall_900 asemeCall
highlight default link asemeChoice_1009 asemeChoice
highlight default link asemeChoice_1023 asemeChoice
highlight default link asemeChoice_1030 asemeChoice
highlight default link asemeChoice_1042 asemeChoice
highlight default link asemeChoice_1043 asemeChoice
highlight default link asemeChoice_1045 asemeChoice
highlight default link asemeChoice_1104 asemeChoice
highlight default link asemeChoice_1108 asemeChoice
highlight default link asemeChoice_1116 asemeChoice
highlight default link asemeChoice_137 asemeChoice
highlight default link asemeChoice_218 asemeChoice
highlight default link asemeChoice_223 asemeChoice
highlight default link asemeChoice_566 asemeChoice
highlight default link asemeChoice_573 asemeChoice
highlight default link asemeChoice_940 asemeChoice
highlight default link asemeChoice_954 asemeChoice
highlight default link asemeChoice_961 asemeChoice
highlight default link asemeChoice_973 asemeChoice
highlight default link asemeChoice_974 asemeChoice
highlight default link asemeChoice_990 asemeChoice
highlight default link asemeClause_1012 asemeClause
highlight default link asemeClause_1015 asemeClause
highlight default link asemeClause_1018 asemeClause
highlight default link asemeClause_1021 asemeClause
highlight default link asemeClause_1024 asemeClause
highlight default link asemeClause_1027 asemeClause
highlight default link asemeClause_1033 asemeClause
highlight default link asemeClause_1036 asemeClause
highlight default link asemeClause_1039 asemeClause
highlight default link asemeClause_1041 asemeClause
highlight default link asemeClause_1091 asemeClause
highlight default link asemeClause_1100 asemeClause
highlight default link asemeClause_1135 asemeClause
highlight default link asemeClause_1138 asemeClause
highlight default link asemeClause_1144 asemeClause
highlight default link asemeClause_1145 asemeClause
highlight default link asemeClause_1146 asemeClause
highlight default link asemeClause_1147 asemeClause
highlight default link asemeClause_1148 asemeClause
highlight default link asemeClause_1149 asemeClause
highlight default link asemeClause_1150 asemeClause
highlight default link asemeClause_1151 asemeClause
highlight default link asemeClause_1152 asemeClause
highlight default link asemeClause_1153 asemeClause
highlight default link asemeClause_1154 asemeClause
highlight default link asemeClause_1155 asemeClause
highlight default link asemeClause_1156 asemeClause
highlight default link asemeClause_1157 asemeClause
highlight default link asemeClause_1170 asemeClause
highlight default link asemeClause_1172 asemeClause
highlight default link asemeClause_1183 asemeClause
highlight default link asemeClause_119 asemeClause
highlight default link asemeClause_1198 asemeClause
highlight default link asemeClause_1201 asemeClause
highlight default link asemeClause_1207 asemeClause
highlight default link asemeClause_1208 asemeClause
highlight default link asemeClause_1209 asemeClause
highlight default link asemeClause_1210 asemeClause
highlight default link asemeClause_1211 asemeClause
highlight default link asemeClause_1212 asemeClause
highlight default link asemeClause_1213 asemeClause
highlight default link asemeClause_1214 asemeClause
highlight default link asemeClause_1215 asemeClause
highlight default link asemeClause_1216 asemeClause
highlight default link asemeClause_1217 asemeClause
highlight default link asemeClause_1218 asemeClause
highlight default link asemeClause_1219 asemeClause
highlight default link asemeClause_122 asemeClause
highlight default link asemeClause_1220 asemeClause
highlight default link asemeClause_125 asemeClause
highlight default link asemeClause_1251 asemeClause
highlight default link asemeClause_1254 asemeClause
highlight default link asemeClause_1260 asemeClause
highlight default link asemeClause_1261 asemeClause
highlight default link asemeClause_1262 asemeClause
highlight default link asemeClause_1263 asemeClause
highlight default link asemeClause_1264 asemeClause
highlight default link asemeClause_1265 asemeClause
highlight default link asemeClause_1266 asemeClause
highlight default link asemeClause_1267 asemeClause
highlight default link asemeClause_1268 asemeClause
highlight default link asemeClause_1269 asemeClause
highlight default link asemeClause_1270 asemeClause
highlight default link asemeClause_1271 asemeClause
highlight default link asemeClause_1272 asemeClause
highlight default link asemeClause_1273 asemeClause
highlight default link asemeClause_1281 asemeClause
highlight default link asemeClause_129 asemeClause
highlight default link asemeClause_132 asemeClause
highlight default link asemeClause_135 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_194 asemeClause
highlight default link asemeClause_196 asemeClause
highlight default link asemeClause_199 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_232 asemeClause
highlight default link asemeClause_235 asemeClause
highlight default link asemeClause_238 asemeClause
highlight default link asemeClause_24 asemeClause
highlight default link asemeClause_25 asemeClause
highlight default link asemeClause_26 asemeClause
highlight default link asemeClause_268 asemeClause
highlight default link asemeClause_27 asemeClause
highlight default link asemeClause_271 asemeClause
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
highlight default link asemeClause_288 asemeClause
highlight default link asemeClause_289 asemeClause
highlight default link asemeClause_29 asemeClause
highlight default link asemeClause_290 asemeClause
highlight default link asemeClause_298 asemeClause
highlight default link asemeClause_30 asemeClause
highlight default link asemeClause_302 asemeClause
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
highlight default link asemeClause_324 asemeClause
highlight default link asemeClause_325 asemeClause
highlight default link asemeClause_326 asemeClause
highlight default link asemeClause_327 asemeClause
highlight default link asemeClause_332 asemeClause
highlight default link asemeClause_333 asemeClause
highlight default link asemeClause_335 asemeClause
highlight default link asemeClause_366 asemeClause
highlight default link asemeClause_368 asemeClause
highlight default link asemeClause_379 asemeClause
highlight default link asemeClause_394 asemeClause
highlight default link asemeClause_397 asemeClause
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
highlight default link asemeClause_413 asemeClause
highlight default link asemeClause_414 asemeClause
highlight default link asemeClause_415 asemeClause
highlight default link asemeClause_416 asemeClause
highlight default link asemeClause_453 asemeClause
highlight default link asemeClause_456 asemeClause
highlight default link asemeClause_462 asemeClause
highlight default link asemeClause_463 asemeClause
highlight default link asemeClause_464 asemeClause
highlight default link asemeClause_465 asemeClause
highlight default link asemeClause_466 asemeClause
highlight default link asemeClause_467 asemeClause
highlight default link asemeClause_468 asemeClause
highlight default link asemeClause_469 asemeClause
highlight default link asemeClause_47 asemeClause
highlight default link asemeClause_470 asemeClause
highlight default link asemeClause_471 asemeClause
highlight default link asemeClause_472 asemeClause
highlight default link asemeClause_473 asemeClause
highlight default link asemeClause_474 asemeClause
highlight default link asemeClause_475 asemeClause
highlight default link asemeClause_50 asemeClause
highlight default link asemeClause_504 asemeClause
highlight default link asemeClause_507 asemeClause
highlight default link asemeClause_509 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_569 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_571 asemeClause
highlight default link asemeClause_575 asemeClause
highlight default link asemeClause_578 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_580 asemeClause
highlight default link asemeClause_581 asemeClause
highlight default link asemeClause_584 asemeClause
highlight default link asemeClause_586 asemeClause
highlight default link asemeClause_587 asemeClause
highlight default link asemeClause_588 asemeClause
highlight default link asemeClause_59 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_609 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_620 asemeClause
highlight default link asemeClause_623 asemeClause
highlight default link asemeClause_629 asemeClause
highlight default link asemeClause_63 asemeClause
highlight default link asemeClause_630 asemeClause
highlight default link asemeClause_631 asemeClause
highlight default link asemeClause_632 asemeClause
highlight default link asemeClause_633 asemeClause
highlight default link asemeClause_634 asemeClause
highlight default link asemeClause_635 asemeClause
highlight default link asemeClause_636 asemeClause
highlight default link asemeClause_637 asemeClause
highlight default link asemeClause_638 asemeClause
highlight default link asemeClause_639 asemeClause
highlight default link asemeClause_64 asemeClause
highlight default link asemeClause_640 asemeClause
highlight default link asemeClause_641 asemeClause
highlight default link asemeClause_642 asemeClause
highlight default link asemeClause_65 asemeClause
highlight default link asemeClause_66 asemeClause
highlight default link asemeClause_661 asemeClause
highlight default link asemeClause_664 asemeClause
highlight default link asemeClause_67 asemeClause
highlight default link asemeClause_670 asemeClause
highlight default link asemeClause_671 asemeClause
highlight default link asemeClause_672 asemeClause
highlight default link asemeClause_673 asemeClause
highlight default link asemeClause_674 asemeClause
highlight default link asemeClause_675 asemeClause
highlight default link asemeClause_676 asemeClause
highlight default link asemeClause_677 asemeClause
highlight default link asemeClause_678 asemeClause
highlight default link asemeClause_679 asemeClause
highlight default link asemeClause_68 asemeClause
highlight default link asemeClause_680 asemeClause
highlight default link asemeClause_681 asemeClause
highlight default link asemeClause_682 asemeClause
highlight default link asemeClause_683 asemeClause
highlight default link asemeClause_69 asemeClause
highlight default link asemeClause_719 asemeClause
highlight default link asemeClause_735 asemeClause
highlight default link asemeClause_738 asemeClause
highlight default link asemeClause_744 asemeClause
highlight default link asemeClause_745 asemeClause
highlight default link asemeClause_746 asemeClause
highlight default link asemeClause_747 asemeClause
highlight default link asemeClause_748 asemeClause
highlight default link asemeClause_749 asemeClause
highlight default link asemeClause_750 asemeClause
highlight default link asemeClause_751 asemeClause
highlight default link asemeClause_752 asemeClause
highlight default link asemeClause_753 asemeClause
highlight default link asemeClause_754 asemeClause
highlight default link asemeClause_755 asemeClause
highlight default link asemeClause_756 asemeClause
highlight default link asemeClause_757 asemeClause
highlight default link asemeClause_765 asemeClause
highlight default link asemeClause_769 asemeClause
highlight default link asemeClause_781 asemeClause
highlight default link asemeClause_782 asemeClause
highlight default link asemeClause_783 asemeClause
highlight default link asemeClause_784 asemeClause
highlight default link asemeClause_785 asemeClause
highlight default link asemeClause_786 asemeClause
highlight default link asemeClause_787 asemeClause
highlight default link asemeClause_788 asemeClause
highlight default link asemeClause_789 asemeClause
highlight default link asemeClause_790 asemeClause
highlight default link asemeClause_791 asemeClause
highlight default link asemeClause_792 asemeClause
highlight default link asemeClause_793 asemeClause
highlight default link asemeClause_794 asemeClause
highlight default link asemeClause_799 asemeClause
highlight default link asemeClause_8 asemeClause
highlight default link asemeClause_800 asemeClause
highlight default link asemeClause_802 asemeClause
highlight default link asemeClause_849 asemeClause
highlight default link asemeClause_851 asemeClause
highlight default link asemeClause_862 asemeClause
highlight default link asemeClause_877 asemeClause
highlight default link asemeClause_880 asemeClause
highlight default link asemeClause_886 asemeClause
highlight default link asemeClause_887 asemeClause
highlight default link asemeClause_888 asemeClause
highlight default link asemeClause_889 asemeClause
highlight default link asemeClause_890 asemeClause
highlight default link asemeClause_891 asemeClause
highlight default link asemeClause_892 asemeClause
highlight default link asemeClause_893 asemeClause
highlight default link asemeClause_894 asemeClause
highlight default link asemeClause_895 asemeClause
highlight default link asemeClause_896 asemeClause
highlight default link asemeClause_897 asemeClause
highlight default link asemeClause_898 asemeClause
highlight default link asemeClause_899 asemeClause
highlight default link asemeClause_943 asemeClause
highlight default link asemeClause_946 asemeClause
highlight default link asemeClause_949 asemeClause
highlight default link asemeClause_952 asemeClause
highlight default link asemeClause_955 asemeClause
highlight default link asemeClause_958 asemeClause
highlight default link asemeClause_964 asemeClause
highlight default link asemeClause_967 asemeClause
highlight default link asemeClause_970 asemeClause
highlight default link asemeClause_972 asemeClause
highlight default link asemeComment_1000 asemeComment
highlight default link asemeComment_1006 asemeComment
highlight default link asemeComment_1008 asemeComment
highlight default link asemeComment_1010 asemeComment
highlight default link asemeComment_1013 asemeComment
highlight default link asemeComment_1016 asemeComment
highlight default link asemeComment_1019 asemeComment
highlight default link asemeComment_1022 asemeComment
highlight default link asemeComment_1025 asemeComment
highlight default link asemeComment_1028 asemeComment
highlight default link asemeComment_103 asemeComment
highlight default link asemeComment_1031 asemeComment
highlight default link asemeComment_1034 asemeComment
highlight default link asemeComment_1037 asemeComment
highlight default link asemeComment_1040 asemeComment
highlight default link asemeComment_1046 asemeComment
highlight default link asemeComment_1051 asemeComment
highlight default link asemeComment_1054 asemeComment
highlight default link asemeComment_1059 asemeComment
highlight default link asemeComment_106 asemeComment
highlight default link asemeComment_1062 asemeComment
highlight default link asemeComment_1065 asemeComment
highlight default link asemeComment_1068 asemeComment
highlight default link asemeComment_1070 asemeComment
highlight default link asemeComment_1072 asemeComment
highlight default link asemeComment_1076 asemeComment
highlight default link asemeComment_1079 asemeComment
highlight default link asemeComment_1082 asemeComment
highlight default link asemeComment_1085 asemeComment
highlight default link asemeComment_1087 asemeComment
highlight default link asemeComment_109 asemeComment
highlight default link asemeComment_1092 asemeComment
highlight default link asemeComment_1094 asemeComment
highlight default link asemeComment_1097 asemeComment
highlight default link asemeComment_1099 asemeComment
highlight default link asemeComment_1101 asemeComment
highlight default link asemeComment_1105 asemeComment
highlight default link asemeComment_1109 asemeComment
highlight default link asemeComment_1111 asemeComment
highlight default link asemeComment_1117 asemeComment
highlight default link asemeComment_1119 asemeComment
highlight default link asemeComment_1121 asemeComment
highlight default link asemeComment_1124 asemeComment
highlight default link asemeComment_1126 asemeComment
highlight default link asemeComment_1128 asemeComment
highlight default link asemeComment_1129 asemeComment
highlight default link asemeComment_113 asemeComment
highlight default link asemeComment_1132 asemeComment
highlight default link asemeComment_1134 asemeComment
highlight default link asemeComment_1136 asemeComment
highlight default link asemeComment_1139 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_1164 asemeComment
highlight default link asemeComment_1166 asemeComment
highlight default link asemeComment_1168 asemeComment
highlight default link asemeComment_1171 asemeComment
highlight default link asemeComment_1175 asemeComment
highlight default link asemeComment_1177 asemeComment
highlight default link asemeComment_118 asemeComment
highlight default link asemeComment_1180 asemeComment
highlight default link asemeComment_1182 asemeComment
highlight default link asemeComment_1187 asemeComment
highlight default link asemeComment_1190 asemeComment
highlight default link asemeComment_1192 asemeComment
highlight default link asemeComment_1195 asemeComment
highlight default link asemeComment_1197 asemeComment
highlight default link asemeComment_1199 asemeComment
highlight default link asemeComment_120 asemeComment
highlight default link asemeComment_1202 asemeComment
highlight default link asemeComment_1229 asemeComment
highlight default link asemeComment_123 asemeComment
highlight default link asemeComment_1232 asemeComment
highlight default link asemeComment_1234 asemeComment
highlight default link asemeComment_1236 asemeComment
highlight default link asemeComment_1238 asemeComment
highlight default link asemeComment_1241 asemeComment
highlight default link asemeComment_1244 asemeComment
highlight default link asemeComment_1245 asemeComment
highlight default link asemeComment_1248 asemeComment
highlight default link asemeComment_1250 asemeComment
highlight default link asemeComment_1252 asemeComment
highlight default link asemeComment_1255 asemeComment
highlight default link asemeComment_126 asemeComment
highlight default link asemeComment_128 asemeComment
highlight default link asemeComment_1280 asemeComment
highlight default link asemeComment_1282 asemeComment
highlight default link asemeComment_1284 asemeComment
highlight default link asemeComment_1286 asemeComment
highlight default link asemeComment_1288 asemeComment
highlight default link asemeComment_1290 asemeComment
highlight default link asemeComment_1292 asemeComment
highlight default link asemeComment_1295 asemeComment
highlight default link asemeComment_1297 asemeComment
highlight default link asemeComment_130 asemeComment
highlight default link asemeComment_1300 asemeComment
highlight default link asemeComment_1303 asemeComment
highlight default link asemeComment_1306 asemeComment
highlight default link asemeComment_1312 asemeComment
highlight default link asemeComment_1315 asemeComment
highlight default link asemeComment_133 asemeComment
highlight default link asemeComment_1341 asemeComment
highlight default link asemeComment_1344 asemeComment
highlight default link asemeComment_1352 asemeComment
highlight default link asemeComment_1355 asemeComment
highlight default link asemeComment_136 asemeComment
highlight default link asemeComment_141 asemeComment
highlight default link asemeComment_145 asemeComment
highlight default link asemeComment_150 asemeComment
highlight default link asemeComment_152 asemeComment
highlight default link asemeComment_154 asemeComment
highlight default link asemeComment_156 asemeComment
highlight default link asemeComment_159 asemeComment
highlight default link asemeComment_161 asemeComment
highlight default link asemeComment_164 asemeComment
highlight default link asemeComment_166 asemeComment
highlight default link asemeComment_169 asemeComment
highlight default link asemeComment_172 asemeComment
highlight default link asemeComment_175 asemeComment
highlight default link asemeComment_178 asemeComment
highlight default link asemeComment_182 asemeComment
highlight default link asemeComment_186 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_191 asemeComment
highlight default link asemeComment_193 asemeComment
highlight default link asemeComment_195 asemeComment
highlight default link asemeComment_197 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_200 asemeComment
highlight default link asemeComment_203 asemeComment
highlight default link asemeComment_208 asemeComment
highlight default link asemeComment_211 asemeComment
highlight default link asemeComment_214 asemeComment
highlight default link asemeComment_217 asemeComment
highlight default link asemeComment_219 asemeComment
highlight default link asemeComment_222 asemeComment
highlight default link asemeComment_225 asemeComment
highlight default link asemeComment_229 asemeComment
highlight default link asemeComment_231 asemeComment
highlight default link asemeComment_233 asemeComment
highlight default link asemeComment_236 asemeComment
highlight default link asemeComment_239 asemeComment
highlight default link asemeComment_242 asemeComment
highlight default link asemeComment_247 asemeComment
highlight default link asemeComment_250 asemeComment
highlight default link asemeComment_252 asemeComment
highlight default link asemeComment_254 asemeComment
highlight default link asemeComment_257 asemeComment
highlight default link asemeComment_261 asemeComment
highlight default link asemeComment_262 asemeComment
highlight default link asemeComment_265 asemeComment
highlight default link asemeComment_267 asemeComment
highlight default link asemeComment_269 asemeComment
highlight default link asemeComment_272 asemeComment
highlight default link asemeComment_297 asemeComment
highlight default link asemeComment_299 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_303 asemeComment
highlight default link asemeComment_304 asemeComment
highlight default link asemeComment_307 asemeComment
highlight default link asemeComment_309 asemeComment
highlight default link asemeComment_334 asemeComment
highlight default link asemeComment_338 asemeComment
highlight default link asemeComment_340 asemeComment
highlight default link asemeComment_343 asemeComment
highlight default link asemeComment_345 asemeComment
highlight default link asemeComment_348 asemeComment
highlight default link asemeComment_352 asemeComment
highlight default link asemeComment_354 asemeComment
highlight default link asemeComment_358 asemeComment
highlight default link asemeComment_360 asemeComment
highlight default link asemeComment_362 asemeComment
highlight default link asemeComment_364 asemeComment
highlight default link asemeComment_367 asemeComment
highlight default link asemeComment_371 asemeComment
highlight default link asemeComment_373 asemeComment
highlight default link asemeComment_376 asemeComment
highlight default link asemeComment_378 asemeComment
highlight default link asemeComment_383 asemeComment
highlight default link asemeComment_386 asemeComment
highlight default link asemeComment_388 asemeComment
highlight default link asemeComment_391 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_395 asemeComment
highlight default link asemeComment_398 asemeComment
highlight default link asemeComment_41 asemeComment
highlight default link asemeComment_425 asemeComment
highlight default link asemeComment_429 asemeComment
highlight default link asemeComment_431 asemeComment
highlight default link asemeComment_433 asemeComment
highlight default link asemeComment_435 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_439 asemeComment
highlight default link asemeComment_44 asemeComment
highlight default link asemeComment_442 asemeComment
highlight default link asemeComment_446 asemeComment
highlight default link asemeComment_447 asemeComment
highlight default link asemeComment_450 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_454 asemeComment
highlight default link asemeComment_457 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_48 asemeComment
highlight default link asemeComment_484 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_492 asemeComment
highlight default link asemeComment_494 asemeComment
highlight default link asemeComment_496 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_501 asemeComment
highlight default link asemeComment_503 asemeComment
highlight default link asemeComment_505 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_51 asemeComment
highlight default link asemeComment_512 asemeComment
highlight default link asemeComment_514 asemeComment
highlight default link asemeComment_517 asemeComment
highlight default link asemeComment_520 asemeComment
highlight default link asemeComment_522 asemeComment
highlight default link asemeComment_524 asemeComment
highlight default link asemeComment_526 asemeComment
highlight default link asemeComment_528 asemeComment
highlight default link asemeComment_531 asemeComment
highlight default link asemeComment_534 asemeComment
highlight default link asemeComment_536 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_540 asemeComment
highlight default link asemeComment_544 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_550 asemeComment
highlight default link asemeComment_562 asemeComment
highlight default link asemeComment_565 asemeComment
highlight default link asemeComment_567 asemeComment
highlight default link asemeComment_570 asemeComment
highlight default link asemeComment_572 asemeComment
highlight default link asemeComment_576 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_582 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_591 asemeComment
highlight default link asemeComment_594 asemeComment
highlight default link asemeComment_600 asemeComment
highlight default link asemeComment_602 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_606 asemeComment
highlight default link asemeComment_608 asemeComment
highlight default link asemeComment_610 asemeComment
highlight default link asemeComment_613 asemeComment
highlight default link asemeComment_614 asemeComment
highlight default link asemeComment_617 asemeComment
highlight default link asemeComment_619 asemeComment
highlight default link asemeComment_621 asemeComment
highlight default link asemeComment_624 asemeComment
highlight default link asemeComment_655 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_660 asemeComment
highlight default link asemeComment_662 asemeComment
highlight default link asemeComment_665 asemeComment
highlight default link asemeComment_690 asemeComment
highlight default link asemeComment_692 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_699 asemeComment
highlight default link asemeComment_7 asemeComment
highlight default link asemeComment_702 asemeComment
highlight default link asemeComment_705 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_710 asemeComment
highlight default link asemeComment_713 asemeComment
highlight default link asemeComment_716 asemeComment
highlight default link asemeComment_718 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_722 asemeComment
highlight default link asemeComment_724 asemeComment
highlight default link asemeComment_728 asemeComment
highlight default link asemeComment_729 asemeComment
highlight default link asemeComment_732 asemeComment
highlight default link asemeComment_734 asemeComment
highlight default link asemeComment_736 asemeComment
highlight default link asemeComment_739 asemeComment
highlight default link asemeComment_76 asemeComment
highlight default link asemeComment_764 asemeComment
highlight default link asemeComment_766 asemeComment
highlight default link asemeComment_768 asemeComment
highlight default link asemeComment_770 asemeComment
highlight default link asemeComment_771 asemeComment
highlight default link asemeComment_774 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_78 asemeComment
highlight default link asemeComment_80 asemeComment
highlight default link asemeComment_801 asemeComment
highlight default link asemeComment_805 asemeComment
highlight default link asemeComment_807 asemeComment
highlight default link asemeComment_810 asemeComment
highlight default link asemeComment_812 asemeComment
highlight default link asemeComment_815 asemeComment
highlight default link asemeComment_819 asemeComment
highlight default link asemeComment_82 asemeComment
highlight default link asemeComment_821 asemeComment
highlight default link asemeComment_825 asemeComment
highlight default link asemeComment_827 asemeComment
highlight default link asemeComment_829 asemeComment
highlight default link asemeComment_831 asemeComment
highlight default link asemeComment_833 asemeComment
highlight default link asemeComment_836 asemeComment
highlight default link asemeComment_840 asemeComment
highlight default link asemeComment_843 asemeComment
highlight default link asemeComment_845 asemeComment
highlight default link asemeComment_847 asemeComment
highlight default link asemeComment_850 asemeComment
highlight default link asemeComment_854 asemeComment
highlight default link asemeComment_856 asemeComment
highlight default link asemeComment_859 asemeComment
highlight default link asemeComment_861 asemeComment
highlight default link asemeComment_866 asemeComment
highlight default link asemeComment_869 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_871 asemeComment
highlight default link asemeComment_874 asemeComment
highlight default link asemeComment_876 asemeComment
highlight default link asemeComment_878 asemeComment
highlight default link asemeComment_881 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_90 asemeComment
highlight default link asemeComment_908 asemeComment
highlight default link asemeComment_911 asemeComment
highlight default link asemeComment_913 asemeComment
highlight default link asemeComment_915 asemeComment
highlight default link asemeComment_917 asemeComment
highlight default link asemeComment_92 asemeComment
highlight default link asemeComment_921 asemeComment
highlight default link asemeComment_924 asemeComment
highlight default link asemeComment_927 asemeComment
highlight default link asemeComment_937 asemeComment
highlight default link asemeComment_939 asemeComment
highlight default link asemeComment_94 asemeComment
highlight default link asemeComment_941 asemeComment
highlight default link asemeComment_944 asemeComment
highlight default link asemeComment_947 asemeComment
highlight default link asemeComment_950 asemeComment
highlight default link asemeComment_953 asemeComment
highlight default link asemeComment_956 asemeComment
highlight default link asemeComment_959 asemeComment
highlight default link asemeComment_962 asemeComment
highlight default link asemeComment_965 asemeComment
highlight default link asemeComment_968 asemeComment
highlight default link asemeComment_971 asemeComment
highlight default link asemeComment_978 asemeComment
highlight default link asemeComment_98 asemeComment
highlight default link asemeComment_980 asemeComment
highlight default link asemeComment_982 asemeComment
highlight default link asemeComment_986 asemeComment
highlight default link asemeComment_988 asemeComment
highlight default link asemeComment_991 asemeComment
highlight default link asemeComment_996 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_1005 asemeDeclaration
highlight default link asemeDeclaration_105 asemeDeclaration
highlight default link asemeDeclaration_1058 asemeDeclaration
highlight default link asemeDeclaration_1061 asemeDeclaration
highlight default link asemeDeclaration_1067 asemeDeclaration
highlight default link asemeDeclaration_1086 asemeDeclaration
highlight default link asemeDeclaration_1093 asemeDeclaration
highlight default link asemeDeclaration_1096 asemeDeclaration
highlight default link asemeDeclaration_1120 asemeDeclaration
highlight default link asemeDeclaration_115 asemeDeclaration
highlight default link asemeDeclaration_1165 asemeDeclaration
highlight default link asemeDeclaration_12 asemeDeclaration
highlight default link asemeDeclaration_1228 asemeDeclaration
highlight default link asemeDeclaration_1233 asemeDeclaration
highlight default link asemeDeclaration_1235 asemeDeclaration
highlight default link asemeDeclaration_1237 asemeDeclaration
highlight default link asemeDeclaration_1243 asemeDeclaration
highlight default link asemeDeclaration_1314 asemeDeclaration
highlight default link asemeDeclaration_1343 asemeDeclaration
highlight default link asemeDeclaration_1354 asemeDeclaration
highlight default link asemeDeclaration_144 asemeDeclaration
highlight default link asemeDeclaration_149 asemeDeclaration
highlight default link asemeDeclaration_190 asemeDeclaration
highlight default link asemeDeclaration_207 asemeDeclaration
highlight default link asemeDeclaration_213 asemeDeclaration
highlight default link asemeDeclaration_216 asemeDeclaration
highlight default link asemeDeclaration_228 asemeDeclaration
highlight default link asemeDeclaration_246 asemeDeclaration
highlight default link asemeDeclaration_249 asemeDeclaration
highlight default link asemeDeclaration_260 asemeDeclaration
highlight default link asemeDeclaration_361 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_424 asemeDeclaration
highlight default link asemeDeclaration_432 asemeDeclaration
highlight default link asemeDeclaration_495 asemeDeclaration
highlight default link asemeDeclaration_500 asemeDeclaration
highlight default link asemeDeclaration_521 asemeDeclaration
highlight default link asemeDeclaration_535 asemeDeclaration
highlight default link asemeDeclaration_561 asemeDeclaration
highlight default link asemeDeclaration_564 asemeDeclaration
highlight default link asemeDeclaration_597 asemeDeclaration
highlight default link asemeDeclaration_601 asemeDeclaration
highlight default link asemeDeclaration_654 asemeDeclaration
highlight default link asemeDeclaration_709 asemeDeclaration
highlight default link asemeDeclaration_715 asemeDeclaration
highlight default link asemeDeclaration_727 asemeDeclaration
highlight default link asemeDeclaration_77 asemeDeclaration
highlight default link asemeDeclaration_828 asemeDeclaration
highlight default link asemeDeclaration_844 asemeDeclaration
highlight default link asemeDeclaration_89 asemeDeclaration
highlight default link asemeDeclaration_907 asemeDeclaration
highlight default link asemeDeclaration_912 asemeDeclaration
highlight default link asemeDeclaration_936 asemeDeclaration
highlight default link asemeLogic_1143 asemeLogic
highlight default link asemeLogic_1206 asemeLogic
highlight default link asemeLogic_1259 asemeLogic
highlight default link asemeLogic_16 asemeLogic
highlight default link asemeLogic_276 asemeLogic
highlight default link asemeLogic_313 asemeLogic
highlight default link asemeLogic_402 asemeLogic
highlight default link asemeLogic_461 asemeLogic
highlight default link asemeLogic_55 asemeLogic
highlight default link asemeLogic_628 asemeLogic
highlight default link asemeLogic_669 asemeLogic
highlight default link asemeLogic_743 asemeLogic
highlight default link asemeLogic_780 asemeLogic
highlight default link asemeLogic_885 asemeLogic
highlight default link asemeName_100 asemeName
highlight default link asemeName_1003 asemeName
highlight default link asemeName_101 asemeName
highlight default link asemeName_1056 asemeName
highlight default link asemeName_107 asemeName
highlight default link asemeName_1102 asemeName
highlight default link asemeName_1106 asemeName
highlight default link asemeName_1112 asemeName
highlight default link asemeName_1114 asemeName
highlight default link asemeName_1226 asemeName
highlight default link asemeName_1227 asemeName
highlight default link asemeName_1231 asemeName
highlight default link asemeName_1279 asemeName
highlight default link asemeName_1299 asemeName
highlight default link asemeName_1301 asemeName
highlight default link asemeName_1309 asemeName
highlight default link asemeName_170 asemeName
highlight default link asemeName_180 asemeName
highlight default link asemeName_185 asemeName
highlight default link asemeName_188 asemeName
highlight default link asemeName_205 asemeName
highlight default link asemeName_206 asemeName
highlight default link asemeName_244 asemeName
highlight default link asemeName_245 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_422 asemeName
highlight default link asemeName_423 asemeName
highlight default link asemeName_430 asemeName
highlight default link asemeName_485 asemeName
highlight default link asemeName_493 asemeName
highlight default link asemeName_498 asemeName
highlight default link asemeName_537 asemeName
highlight default link asemeName_545 asemeName
highlight default link asemeName_557 asemeName
highlight default link asemeName_577 asemeName
highlight default link asemeName_589 asemeName
highlight default link asemeName_596 asemeName
highlight default link asemeName_599 asemeName
highlight default link asemeName_75 asemeName
highlight default link asemeName_839 asemeName
highlight default link asemeName_84 asemeName
highlight default link asemeName_842 asemeName
highlight default link asemeName_905 asemeName
highlight default link asemeName_906 asemeName
highlight default link asemeName_910 asemeName
highlight default link asemeName_914 asemeName
highlight default link asemeName_922 asemeName
highlight default link asemeName_934 asemeName
highlight default link asemeName_96 asemeName
highlight default link asemeName_979 asemeName
highlight default link asemeName_987 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1014 asemeNumber
highlight default link asemeNumber_1017 asemeNumber
highlight default link asemeNumber_1020 asemeNumber
highlight default link asemeNumber_1032 asemeNumber
highlight default link asemeNumber_1110 asemeNumber
highlight default link asemeNumber_1118 asemeNumber
highlight default link asemeNumber_1123 asemeNumber
highlight default link asemeNumber_1127 asemeNumber
highlight default link asemeNumber_1141 asemeNumber
highlight default link asemeNumber_1163 asemeNumber
highlight default link asemeNumber_1174 asemeNumber
highlight default link asemeNumber_1178 asemeNumber
highlight default link asemeNumber_1181 asemeNumber
highlight default link asemeNumber_1188 asemeNumber
highlight default link asemeNumber_1204 asemeNumber
highlight default link asemeNumber_121 asemeNumber
highlight default link asemeNumber_124 asemeNumber
highlight default link asemeNumber_1257 asemeNumber
highlight default link asemeNumber_1285 asemeNumber
highlight default link asemeNumber_1289 asemeNumber
highlight default link asemeNumber_1294 asemeNumber
highlight default link asemeNumber_131 asemeNumber
highlight default link asemeNumber_1317 asemeNumber
highlight default link asemeNumber_1323 asemeNumber
highlight default link asemeNumber_1329 asemeNumber
highlight default link asemeNumber_1335 asemeNumber
highlight default link asemeNumber_134 asemeNumber
highlight default link asemeNumber_1346 asemeNumber
highlight default link asemeNumber_1358 asemeNumber
highlight default link asemeNumber_14 asemeNumber
highlight default link asemeNumber_251 asemeNumber
highlight default link asemeNumber_255 asemeNumber
highlight default link asemeNumber_274 asemeNumber
highlight default link asemeNumber_311 asemeNumber
highlight default link asemeNumber_37 asemeNumber
highlight default link asemeNumber_370 asemeNumber
highlight default link asemeNumber_374 asemeNumber
highlight default link asemeNumber_377 asemeNumber
highlight default link asemeNumber_384 asemeNumber
highlight default link asemeNumber_400 asemeNumber
highlight default link asemeNumber_434 asemeNumber
highlight default link asemeNumber_438 asemeNumber
highlight default link asemeNumber_440 asemeNumber
highlight default link asemeNumber_459 asemeNumber
highlight default link asemeNumber_53 asemeNumber
highlight default link asemeNumber_551 asemeNumber
highlight default link asemeNumber_553 asemeNumber
highlight default link asemeNumber_568 asemeNumber
highlight default link asemeNumber_574 asemeNumber
highlight default link asemeNumber_583 asemeNumber
highlight default link asemeNumber_607 asemeNumber
highlight default link asemeNumber_611 asemeNumber
highlight default link asemeNumber_626 asemeNumber
highlight default link asemeNumber_649 asemeNumber
highlight default link asemeNumber_651 asemeNumber
highlight default link asemeNumber_667 asemeNumber
highlight default link asemeNumber_689 asemeNumber
highlight default link asemeNumber_693 asemeNumber
highlight default link asemeNumber_741 asemeNumber
highlight default link asemeNumber_778 asemeNumber
highlight default link asemeNumber_79 asemeNumber
highlight default link asemeNumber_853 asemeNumber
highlight default link asemeNumber_857 asemeNumber
highlight default link asemeNumber_860 asemeNumber
highlight default link asemeNumber_867 asemeNumber
highlight default link asemeNumber_883 asemeNumber
highlight default link asemeNumber_91 asemeNumber
highlight default link asemeNumber_928 asemeNumber
highlight default link asemeNumber_930 asemeNumber
highlight default link asemeNumber_945 asemeNumber
highlight default link asemeNumber_948 asemeNumber
highlight default link asemeNumber_951 asemeNumber
highlight default link asemeNumber_963 asemeNumber
highlight default link asemeOperator_1053 asemeOperator
highlight default link asemeOperator_1069 asemeOperator
highlight default link asemeOperator_1071 asemeOperator
highlight default link asemeOperator_1073 asemeOperator
highlight default link asemeOperator_1074 asemeOperator
highlight default link asemeOperator_1075 asemeOperator
highlight default link asemeOperator_1077 asemeOperator
highlight default link asemeOperator_1080 asemeOperator
highlight default link asemeOperator_1081 asemeOperator
highlight default link asemeOperator_1083 asemeOperator
highlight default link asemeOperator_1125 asemeOperator
highlight default link asemeOperator_1160 asemeOperator
highlight default link asemeOperator_1223 asemeOperator
highlight default link asemeOperator_1225 asemeOperator
highlight default link asemeOperator_1230 asemeOperator
highlight default link asemeOperator_1276 asemeOperator
highlight default link asemeOperator_1278 asemeOperator
highlight default link asemeOperator_1298 asemeOperator
highlight default link asemeOperator_1308 asemeOperator
highlight default link asemeOperator_1319 asemeOperator
highlight default link asemeOperator_1325 asemeOperator
highlight default link asemeOperator_1331 asemeOperator
highlight default link asemeOperator_1337 asemeOperator
highlight default link asemeOperator_1348 asemeOperator
highlight default link asemeOperator_153 asemeOperator
highlight default link asemeOperator_163 asemeOperator
highlight default link asemeOperator_177 asemeOperator
highlight default link asemeOperator_293 asemeOperator
highlight default link asemeOperator_295 asemeOperator
highlight default link asemeOperator_33 asemeOperator
highlight default link asemeOperator_330 asemeOperator
highlight default link asemeOperator_341 asemeOperator
highlight default link asemeOperator_349 asemeOperator
highlight default link asemeOperator_419 asemeOperator
highlight default link asemeOperator_421 asemeOperator
highlight default link asemeOperator_478 asemeOperator
highlight default link asemeOperator_480 asemeOperator
highlight default link asemeOperator_497 asemeOperator
highlight default link asemeOperator_554 asemeOperator
highlight default link asemeOperator_556 asemeOperator
highlight default link asemeOperator_593 asemeOperator
highlight default link asemeOperator_598 asemeOperator
highlight default link asemeOperator_603 asemeOperator
highlight default link asemeOperator_605 asemeOperator
highlight default link asemeOperator_612 asemeOperator
highlight default link asemeOperator_645 asemeOperator
highlight default link asemeOperator_652 asemeOperator
highlight default link asemeOperator_686 asemeOperator
highlight default link asemeOperator_691 asemeOperator
highlight default link asemeOperator_696 asemeOperator
highlight default link asemeOperator_697 asemeOperator
highlight default link asemeOperator_698 asemeOperator
highlight default link asemeOperator_700 asemeOperator
highlight default link asemeOperator_703 asemeOperator
highlight default link asemeOperator_704 asemeOperator
highlight default link asemeOperator_706 asemeOperator
highlight default link asemeOperator_72 asemeOperator
highlight default link asemeOperator_74 asemeOperator
highlight default link asemeOperator_760 asemeOperator
highlight default link asemeOperator_762 asemeOperator
highlight default link asemeOperator_797 asemeOperator
highlight default link asemeOperator_808 asemeOperator
highlight default link asemeOperator_81 asemeOperator
highlight default link asemeOperator_816 asemeOperator
highlight default link asemeOperator_832 asemeOperator
highlight default link asemeOperator_902 asemeOperator
highlight default link asemeOperator_904 asemeOperator
highlight default link asemeOperator_909 asemeOperator
highlight default link asemeOperator_93 asemeOperator
highlight default link asemeOperator_931 asemeOperator
highlight default link asemeOperator_933 asemeOperator
highlight default link asemePunctuation_1001 asemePunctuation
highlight default link asemePunctuation_1004 asemePunctuation
highlight default link asemePunctuation_1050 asemePunctuation
highlight default link asemePunctuation_1057 asemePunctuation
highlight default link asemePunctuation_1063 asemePunctuation
highlight default link asemePunctuation_1088 asemePunctuation
highlight default link asemePunctuation_111 asemePunctuation
highlight default link asemePunctuation_1122 asemePunctuation
highlight default link asemePunctuation_1130 asemePunctuation
highlight default link asemePunctuation_1161 asemePunctuation
highlight default link asemePunctuation_1162 asemePunctuation
highlight default link asemePunctuation_1173 asemePunctuation
highlight default link asemePunctuation_1176 asemePunctuation
highlight default link asemePunctuation_1179 asemePunctuation
highlight default link asemePunctuation_1186 asemePunctuation
highlight default link asemePunctuation_1189 asemePunctuation
highlight default link asemePunctuation_1191 asemePunctuation
highlight default link asemePunctuation_1193 asemePunctuation
highlight default link asemePunctuation_1224 asemePunctuation
highlight default link asemePunctuation_1239 asemePunctuation
highlight default link asemePunctuation_1246 asemePunctuation
highlight default link asemePunctuation_1277 asemePunctuation
highlight default link asemePunctuation_1283 asemePunctuation
highlight default link asemePunctuation_1287 asemePunctuation
highlight default link asemePunctuation_1291 asemePunctuation
highlight default link asemePunctuation_1293 asemePunctuation
highlight default link asemePunctuation_1296 asemePunctuation
highlight default link asemePunctuation_1302 asemePunctuation
highlight default link asemePunctuation_1305 asemePunctuation
highlight default link asemePunctuation_1307 asemePunctuation
highlight default link asemePunctuation_1310 asemePunctuation
highlight default link asemePunctuation_1320 asemePunctuation
highlight default link asemePunctuation_1321 asemePunctuation
highlight default link asemePunctuation_1326 asemePunctuation
highlight default link asemePunctuation_1327 asemePunctuation
highlight default link asemePunctuation_1332 asemePunctuation
highlight default link asemePunctuation_1333 asemePunctuation
highlight default link asemePunctuation_1338 asemePunctuation
highlight default link asemePunctuation_1339 asemePunctuation
highlight default link asemePunctuation_1349 asemePunctuation
highlight default link asemePunctuation_1350 asemePunctuation
highlight default link asemePunctuation_1361 asemePunctuation
highlight default link asemePunctuation_140 asemePunctuation
highlight default link asemePunctuation_146 asemePunctuation
highlight default link asemePunctuation_158 asemePunctuation
highlight default link asemePunctuation_160 asemePunctuation
highlight default link asemePunctuation_168 asemePunctuation
highlight default link asemePunctuation_174 asemePunctuation
highlight default link asemePunctuation_179 asemePunctuation
highlight default link asemePunctuation_184 asemePunctuation
highlight default link asemePunctuation_187 asemePunctuation
highlight default link asemePunctuation_202 asemePunctuation
highlight default link asemePunctuation_209 asemePunctuation
highlight default link asemePunctuation_215 asemePunctuation
highlight default link asemePunctuation_221 asemePunctuation
highlight default link asemePunctuation_224 asemePunctuation
highlight default link asemePunctuation_241 asemePunctuation
highlight default link asemePunctuation_248 asemePunctuation
highlight default link asemePunctuation_253 asemePunctuation
highlight default link asemePunctuation_256 asemePunctuation
highlight default link asemePunctuation_258 asemePunctuation
highlight default link asemePunctuation_263 asemePunctuation
highlight default link asemePunctuation_294 asemePunctuation
highlight default link asemePunctuation_305 asemePunctuation
highlight default link asemePunctuation_331 asemePunctuation
highlight default link asemePunctuation_337 asemePunctuation
highlight default link asemePunctuation_34 asemePunctuation
highlight default link asemePunctuation_344 asemePunctuation
highlight default link asemePunctuation_347 asemePunctuation
highlight default link asemePunctuation_351 asemePunctuation
highlight default link asemePunctuation_357 asemePunctuation
highlight default link asemePunctuation_369 asemePunctuation
highlight default link asemePunctuation_372 asemePunctuation
highlight default link asemePunctuation_375 asemePunctuation
highlight default link asemePunctuation_382 asemePunctuation
highlight default link asemePunctuation_385 asemePunctuation
highlight default link asemePunctuation_387 asemePunctuation
highlight default link asemePunctuation_389 asemePunctuation
highlight default link asemePunctuation_40 asemePunctuation
highlight default link asemePunctuation_42 asemePunctuation
highlight default link asemePunctuation_420 asemePunctuation
highlight default link asemePunctuation_428 asemePunctuation
highlight default link asemePunctuation_436 asemePunctuation
highlight default link asemePunctuation_441 asemePunctuation
highlight default link asemePunctuation_445 asemePunctuation
highlight default link asemePunctuation_448 asemePunctuation
highlight default link asemePunctuation_479 asemePunctuation
highlight default link asemePunctuation_483 asemePunctuation
highlight default link asemePunctuation_491 asemePunctuation
highlight default link asemePunctuation_513 asemePunctuation
highlight default link asemePunctuation_527 asemePunctuation
highlight default link asemePunctuation_539 asemePunctuation
highlight default link asemePunctuation_543 asemePunctuation
highlight default link asemePunctuation_546 asemePunctuation
highlight default link asemePunctuation_548 asemePunctuation
highlight default link asemePunctuation_555 asemePunctuation
highlight default link asemePunctuation_558 asemePunctuation
highlight default link asemePunctuation_590 asemePunctuation
highlight default link asemePunctuation_595 asemePunctuation
highlight default link asemePunctuation_615 asemePunctuation
highlight default link asemePunctuation_646 asemePunctuation
highlight default link asemePunctuation_647 asemePunctuation
highlight default link asemePunctuation_653 asemePunctuation
highlight default link asemePunctuation_656 asemePunctuation
highlight default link asemePunctuation_687 asemePunctuation
highlight default link asemePunctuation_688 asemePunctuation
highlight default link asemePunctuation_695 asemePunctuation
highlight default link asemePunctuation_711 asemePunctuation
highlight default link asemePunctuation_723 asemePunctuation
highlight default link asemePunctuation_73 asemePunctuation
highlight default link asemePunctuation_730 asemePunctuation
highlight default link asemePunctuation_761 asemePunctuation
highlight default link asemePunctuation_772 asemePunctuation
highlight default link asemePunctuation_798 asemePunctuation
highlight default link asemePunctuation_804 asemePunctuation
highlight default link asemePunctuation_811 asemePunctuation
highlight default link asemePunctuation_814 asemePunctuation
highlight default link asemePunctuation_818 asemePunctuation
highlight default link asemePunctuation_824 asemePunctuation
highlight default link asemePunctuation_83 asemePunctuation
highlight default link asemePunctuation_835 asemePunctuation
highlight default link asemePunctuation_85 asemePunctuation
highlight default link asemePunctuation_852 asemePunctuation
highlight default link asemePunctuation_855 asemePunctuation
highlight default link asemePunctuation_858 asemePunctuation
highlight default link asemePunctuation_865 asemePunctuation
highlight default link asemePunctuation_868 asemePunctuation
highlight default link asemePunctuation_870 asemePunctuation
highlight default link asemePunctuation_872 asemePunctuation
highlight default link asemePunctuation_903 asemePunctuation
highlight default link asemePunctuation_916 asemePunctuation
highlight default link asemePunctuation_920 asemePunctuation
highlight default link asemePunctuation_923 asemePunctuation
highlight default link asemePunctuation_925 asemePunctuation
highlight default link asemePunctuation_932 asemePunctuation
highlight default link asemePunctuation_935 asemePunctuation
highlight default link asemePunctuation_95 asemePunctuation
highlight default link asemePunctuation_977 asemePunctuation
highlight default link asemePunctuation_981 asemePunctuation
highlight default link asemePunctuation_985 asemePunctuation
highlight default link asemePunctuation_995 asemePunctuation
highlight default link asemePunctuation_999 asemePunctuation
highlight default link asemeReference_1002 asemeReference
highlight default link asemeReference_1007 asemeReference
highlight default link asemeReference_1011 asemeReference
highlight default link asemeReference_1026 asemeReference
highlight default link asemeReference_1029 asemeReference
highlight default link asemeReference_1035 asemeReference
highlight default link asemeReference_1038 asemeReference
highlight default link asemeReference_1044 asemeReference
highlight default link asemeReference_1047 asemeReference
highlight default link asemeReference_1048 asemeReference
highlight default link asemeReference_1049 asemeReference
highlight default link asemeReference_1055 asemeReference
highlight default link asemeReference_1098 asemeReference
highlight default link asemeReference_11 asemeReference
highlight default link asemeReference_1131 asemeReference
highlight default link asemeReference_1133 asemeReference
highlight default link asemeReference_1137 asemeReference
highlight default link asemeReference_1159 asemeReference
highlight default link asemeReference_117 asemeReference
highlight default link asemeReference_1194 asemeReference
highlight default link asemeReference_1196 asemeReference
highlight default link asemeReference_1200 asemeReference
highlight default link asemeReference_1222 asemeReference
highlight default link asemeReference_1247 asemeReference
highlight default link asemeReference_1249 asemeReference
highlight default link asemeReference_1253 asemeReference
highlight default link asemeReference_127 asemeReference
highlight default link asemeReference_1275 asemeReference
highlight default link asemeReference_1304 asemeReference
highlight default link asemeReference_1318 asemeReference
highlight default link asemeReference_1324 asemeReference
highlight default link asemeReference_1330 asemeReference
highlight default link asemeReference_1336 asemeReference
highlight default link asemeReference_1347 asemeReference
highlight default link asemeReference_1359 asemeReference
highlight default link asemeReference_1360 asemeReference
highlight default link asemeReference_138 asemeReference
highlight default link asemeReference_139 asemeReference
highlight default link asemeReference_142 asemeReference
highlight default link asemeReference_143 asemeReference
highlight default link asemeReference_192 asemeReference
highlight default link asemeReference_198 asemeReference
highlight default link asemeReference_201 asemeReference
highlight default link asemeReference_220 asemeReference
highlight default link asemeReference_226 asemeReference
highlight default link asemeReference_227 asemeReference
highlight default link asemeReference_230 asemeReference
highlight default link asemeReference_234 asemeReference
highlight default link asemeReference_237 asemeReference
highlight default link asemeReference_240 asemeReference
highlight default link asemeReference_264 asemeReference
highlight default link asemeReference_266 asemeReference
highlight default link asemeReference_270 asemeReference
highlight default link asemeReference_292 asemeReference
highlight default link asemeReference_296 asemeReference
highlight default link asemeReference_300 asemeReference
highlight default link asemeReference_306 asemeReference
highlight default link asemeReference_308 asemeReference
highlight default link asemeReference_32 asemeReference
highlight default link asemeReference_329 asemeReference
highlight default link asemeReference_336 asemeReference
highlight default link asemeReference_339 asemeReference
highlight default link asemeReference_342 asemeReference
highlight default link asemeReference_346 asemeReference
highlight default link asemeReference_350 asemeReference
highlight default link asemeReference_353 asemeReference
highlight default link asemeReference_355 asemeReference
highlight default link asemeReference_356 asemeReference
highlight default link asemeReference_359 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_39 asemeReference
highlight default link asemeReference_390 asemeReference
highlight default link asemeReference_392 asemeReference
highlight default link asemeReference_396 asemeReference
highlight default link asemeReference_418 asemeReference
highlight default link asemeReference_43 asemeReference
highlight default link asemeReference_449 asemeReference
highlight default link asemeReference_45 asemeReference
highlight default link asemeReference_451 asemeReference
highlight default link asemeReference_455 asemeReference
highlight default link asemeReference_477 asemeReference
highlight default link asemeReference_49 asemeReference
highlight default link asemeReference_502 asemeReference
highlight default link asemeReference_506 asemeReference
highlight default link asemeReference_510 asemeReference
highlight default link asemeReference_511 asemeReference
highlight default link asemeReference_515 asemeReference
highlight default link asemeReference_516 asemeReference
highlight default link asemeReference_518 asemeReference
highlight default link asemeReference_519 asemeReference
highlight default link asemeReference_523 asemeReference
highlight default link asemeReference_525 asemeReference
highlight default link asemeReference_529 asemeReference
highlight default link asemeReference_530 asemeReference
highlight default link asemeReference_532 asemeReference
highlight default link asemeReference_533 asemeReference
highlight default link asemeReference_552 asemeReference
highlight default link asemeReference_592 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_616 asemeReference
highlight default link asemeReference_618 asemeReference
highlight default link asemeReference_622 asemeReference
highlight default link asemeReference_644 asemeReference
highlight default link asemeReference_650 asemeReference
highlight default link asemeReference_657 asemeReference
highlight default link asemeReference_659 asemeReference
highlight default link asemeReference_663 asemeReference
highlight default link asemeReference_685 asemeReference
highlight default link asemeReference_71 asemeReference
highlight default link asemeReference_721 asemeReference
highlight default link asemeReference_725 asemeReference
highlight default link asemeReference_726 asemeReference
highlight default link asemeReference_731 asemeReference
highlight default link asemeReference_733 asemeReference
highlight default link asemeReference_737 asemeReference
highlight default link asemeReference_759 asemeReference
highlight default link asemeReference_763 asemeReference
highlight default link asemeReference_767 asemeReference
highlight default link asemeReference_773 asemeReference
highlight default link asemeReference_775 asemeReference
highlight default link asemeReference_796 asemeReference
highlight default link asemeReference_803 asemeReference
highlight default link asemeReference_806 asemeReference
highlight default link asemeReference_809 asemeReference
highlight default link asemeReference_813 asemeReference
highlight default link asemeReference_817 asemeReference
highlight default link asemeReference_820 asemeReference
highlight default link asemeReference_822 asemeReference
highlight default link asemeReference_823 asemeReference
highlight default link asemeReference_826 asemeReference
highlight default link asemeReference_830 asemeReference
highlight default link asemeReference_834 asemeReference
highlight default link asemeReference_873 asemeReference
highlight default link asemeReference_875 asemeReference
highlight default link asemeReference_879 asemeReference
highlight default link asemeReference_901 asemeReference
highlight default link asemeReference_929 asemeReference
highlight default link asemeReference_938 asemeReference
highlight default link asemeReference_942 asemeReference
highlight default link asemeReference_957 asemeReference
highlight default link asemeReference_960 asemeReference
highlight default link asemeReference_966 asemeReference
highlight default link asemeReference_969 asemeReference
highlight default link asemeReference_989 asemeReference
highlight default link asemeReference_992 asemeReference
highlight default link asemeReference_993 asemeReference
highlight default link asemeReference_994 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1052 asemeText
highlight default link asemeText_1060 asemeText
highlight default link asemeText_1103 asemeText
highlight default link asemeText_1107 asemeText
highlight default link asemeText_1113 asemeText
highlight default link asemeText_1115 asemeText
highlight default link asemeText_1140 asemeText
highlight default link asemeText_1203 asemeText
highlight default link asemeText_1256 asemeText
highlight default link asemeText_13 asemeText
highlight default link asemeText_1316 asemeText
highlight default link asemeText_1322 asemeText
highlight default link asemeText_1328 asemeText
highlight default link asemeText_1334 asemeText
highlight default link asemeText_1340 asemeText
highlight default link asemeText_1342 asemeText
highlight default link asemeText_1345 asemeText
highlight default link asemeText_1351 asemeText
highlight default link asemeText_1353 asemeText
highlight default link asemeText_1356 asemeText
highlight default link asemeText_1357 asemeText
highlight default link asemeText_151 asemeText
highlight default link asemeText_162 asemeText
highlight default link asemeText_176 asemeText
highlight default link asemeText_204 asemeText
highlight default link asemeText_243 asemeText
highlight default link asemeText_259 asemeText
highlight default link asemeText_273 asemeText
highlight default link asemeText_310 asemeText
highlight default link asemeText_35 asemeText
highlight default link asemeText_36 asemeText
highlight default link asemeText_399 asemeText
highlight default link asemeText_458 asemeText
highlight default link asemeText_52 asemeText
highlight default link asemeText_549 asemeText
highlight default link asemeText_563 asemeText
highlight default link asemeText_625 asemeText
highlight default link asemeText_648 asemeText
highlight default link asemeText_666 asemeText
highlight default link asemeText_740 asemeText
highlight default link asemeText_777 asemeText
highlight default link asemeText_837 asemeText
highlight default link asemeText_838 asemeText
highlight default link asemeText_841 asemeText
highlight default link asemeText_882 asemeText
highlight default link asemeText_926 asemeText
highlight default link asemeTruth_1142 asemeTruth
highlight default link asemeTruth_1205 asemeTruth
highlight default link asemeTruth_1258 asemeTruth
highlight default link asemeTruth_15 asemeTruth
highlight default link asemeTruth_275 asemeTruth
highlight default link asemeTruth_312 asemeTruth
highlight default link asemeTruth_401 asemeTruth
highlight default link asemeTruth_460 asemeTruth
highlight default link asemeTruth_54 asemeTruth
highlight default link asemeTruth_627 asemeTruth
highlight default link asemeTruth_668 asemeTruth
highlight default link asemeTruth_742 asemeTruth
highlight default link asemeTruth_779 asemeTruth
highlight default link asemeTruth_884 asemeTruth
highlight default link asemeType_104 asemeType
highlight default link asemeType_110 asemeType
highlight default link asemeType_1169 asemeType
highlight default link asemeType_1185 asemeType
highlight default link asemeType_157 asemeType
highlight default link asemeType_167 asemeType
highlight default link asemeType_173 asemeType
highlight default link asemeType_183 asemeType
highlight default link asemeType_365 asemeType
highlight default link asemeType_381 asemeType
highlight default link asemeType_427 asemeType
highlight default link asemeType_444 asemeType
highlight default link asemeType_482 asemeType
highlight default link asemeType_488 asemeType
highlight default link asemeType_490 asemeType
highlight default link asemeType_542 asemeType
highlight default link asemeType_848 asemeType
highlight default link asemeType_864 asemeType
highlight default link asemeType_919 asemeType
highlight default link asemeType_976 asemeType
highlight default link asemeType_984 asemeType
highlight default link asemeType_99 asemeType
highlight default link asemeType_998 asemeType
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
