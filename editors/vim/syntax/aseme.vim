" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1374 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1373 /\v\w+/
syntax match asemeNumber_1372 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1371 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1370 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1375 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1370,asemeText_1371,asemeNumber_1372,asemeReference_1373,asemeReference_1374,asemePunctuation_1375,asemeComment
syntax match asemeReference_42 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_41 /\v\w+/ contained
syntax match asemeNumber_40 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_39 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_38 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_43 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_12,asemeDeclaration_81,asemeDeclaration_93,asemeDeclaration_119,asemeDeclaration_153,asemeDeclaration_194,asemeDeclaration_220,asemeDeclaration_253,asemeDeclaration_724,asemeDeclaration_1104,asemeDeclaration_1107,asemeDeclaration_1256,asemeDeclaration_1328,asemeDeclaration_1357,asemeDeclaration_1368,asemeText_1370,asemeText_1371,asemeNumber_1372,asemeReference_1373,asemeReference_1374,asemePunctuation_1375,asemeComment
syntax match asemeDeclaration_1368 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1367,asemeComment_1369 skipwhite skipempty
syntax region asemeComment_1369 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1367,asemeComment_1369 skipwhite skipempty
syntax match asemeComment_1369 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1367,asemeComment_1369 skipwhite skipempty
syntax match asemeText_1367 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1366 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1364,asemeText_1365
syntax match asemeText_1365 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1366 skipwhite skipempty
syntax region asemeComment_1366 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1366 skipwhite skipempty
syntax match asemeComment_1366 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1366 skipwhite skipempty
syntax region asemePunctuation_1364 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_1347,asemeText_1359,asemeNumber_1360,asemeReference_1361,asemeOperator_1362,asemePunctuation_1363,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_1363 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1362 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1361 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1360 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1359 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1357 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_1356,asemeComment_1358 skipwhite skipempty
syntax region asemeComment_1358 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1356,asemeComment_1358 skipwhite skipempty
syntax match asemeComment_1358 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1356,asemeComment_1358 skipwhite skipempty
syntax match asemeText_1356 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1355 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_1353,asemeText_1354
syntax match asemeText_1354 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1355 skipwhite skipempty
syntax region asemeComment_1355 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1355 skipwhite skipempty
syntax match asemeComment_1355 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1355 skipwhite skipempty
syntax region asemePunctuation_1353 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_1347,asemeText_1348,asemeNumber_1349,asemeReference_1350,asemeOperator_1351,asemePunctuation_1352,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_1352 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1351 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1350 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1349 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1348 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1347 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_1341,asemeText_1342,asemeNumber_1343,asemeReference_1344,asemeOperator_1345,asemePunctuation_1346,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_1346 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1345 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1344 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1343 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1342 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1341 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_1335,asemeText_1336,asemeNumber_1337,asemeReference_1338,asemeOperator_1339,asemePunctuation_1340,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_1340 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1339 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1338 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1337 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1336 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1335 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_1330,asemeNumber_1331,asemeReference_1332,asemeOperator_1333,asemePunctuation_1334,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_1334 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1333 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1332 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1331 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1330 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1328 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_1327,asemeComment_1329 skipwhite skipempty
syntax region asemeComment_1329 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1327,asemeComment_1329 skipwhite skipempty
syntax match asemeComment_1329 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1327,asemeComment_1329 skipwhite skipempty
syntax match asemeBlock_1327 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1326 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_1324,asemeBlock_1325
syntax match asemeBlock_1325 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1326 skipwhite skipempty
syntax region asemeComment_1326 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1326 skipwhite skipempty
syntax match asemeComment_1326 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1326 skipwhite skipempty
syntax region asemePunctuation_1324 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_1323,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_1323 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_1295,asemePunctuation_1305,asemePunctuation_1310,asemePunctuation_1316,asemePunctuation_1319,asemePunctuation_1321,asemeOperator_1322
syntax match asemeOperator_1322 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemePunctuation_1321 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax match asemePunctuation_1319 /\v\:/ contained nextgroup=asemeReference_1318,asemeComment_1320 skipwhite skipempty
syntax region asemeComment_1320 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1318,asemeComment_1320 skipwhite skipempty
syntax match asemeComment_1320 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1318,asemeComment_1320 skipwhite skipempty
syntax match asemeReference_1318 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax match asemePunctuation_1316 /\v\,/ contained nextgroup=asemeName_1313,asemeName_1315,asemeComment_1317 skipwhite skipempty
syntax region asemeComment_1317 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1313,asemeName_1315,asemeComment_1317 skipwhite skipempty
syntax match asemeComment_1317 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1313,asemeName_1315,asemeComment_1317 skipwhite skipempty
syntax match asemeName_1315 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax match asemeName_1313 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1312,asemeComment_1314 skipwhite skipempty
syntax region asemeComment_1314 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1312,asemeComment_1314 skipwhite skipempty
syntax match asemeComment_1314 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1312,asemeComment_1314 skipwhite skipempty
syntax match asemeOperator_1312 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemePunctuation_1310 /\v\.\./ contained nextgroup=asemeNumber_1308,asemeComment_1311 skipwhite skipempty
syntax region asemeComment_1311 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1308,asemeComment_1311 skipwhite skipempty
syntax match asemeComment_1311 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1308,asemeComment_1311 skipwhite skipempty
syntax match asemeNumber_1308 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1307,asemeComment_1309 skipwhite skipempty
syntax region asemeComment_1309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1307,asemeComment_1309 skipwhite skipempty
syntax match asemeComment_1309 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1307,asemeComment_1309 skipwhite skipempty
syntax match asemePunctuation_1307 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax match asemePunctuation_1305 /\v\[/ contained nextgroup=asemeNumber_1303,asemeComment_1306 skipwhite skipempty
syntax region asemeComment_1306 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1303,asemeComment_1306 skipwhite skipempty
syntax match asemeComment_1306 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1303,asemeComment_1306 skipwhite skipempty
syntax match asemeNumber_1303 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1301,asemeComment_1304 skipwhite skipempty
syntax region asemeComment_1304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1301,asemeComment_1304 skipwhite skipempty
syntax match asemeComment_1304 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1301,asemeComment_1304 skipwhite skipempty
syntax match asemePunctuation_1301 /\v\.\./ contained nextgroup=asemeNumber_1299,asemeComment_1302 skipwhite skipempty
syntax region asemeComment_1302 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1299,asemeComment_1302 skipwhite skipempty
syntax match asemeComment_1302 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1299,asemeComment_1302 skipwhite skipempty
syntax match asemeNumber_1299 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1297,asemeComment_1300 skipwhite skipempty
syntax region asemeComment_1300 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1297,asemeComment_1300 skipwhite skipempty
syntax match asemeComment_1300 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1297,asemeComment_1300 skipwhite skipempty
syntax match asemePunctuation_1297 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax region asemeComment_1298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax match asemeComment_1298 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1298 skipwhite skipempty
syntax match asemeClause_1295 /\vwith%(<|>)/ contained nextgroup=asemeName_1293,asemeComment_1296 skipwhite skipempty
syntax region asemeComment_1296 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1293,asemeComment_1296 skipwhite skipempty
syntax match asemeComment_1296 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1293,asemeComment_1296 skipwhite skipempty
syntax match asemeName_1293 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1292,asemeComment_1294 skipwhite skipempty
syntax region asemeComment_1294 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1292,asemeComment_1294 skipwhite skipempty
syntax match asemeComment_1294 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1292,asemeComment_1294 skipwhite skipempty
syntax match asemeOperator_1292 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeDeclaration_1256 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_1255,asemeComment_1257 skipwhite skipempty
syntax region asemeComment_1257 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1255,asemeComment_1257 skipwhite skipempty
syntax match asemeComment_1257 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1255,asemeComment_1257 skipwhite skipempty
syntax match asemeBlock_1255 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1254 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_1252,asemeBlock_1253
syntax match asemeBlock_1253 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1254 skipwhite skipempty
syntax region asemeComment_1254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1254 skipwhite skipempty
syntax match asemeComment_1254 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1254 skipwhite skipempty
syntax region asemePunctuation_1252 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_1131,asemeNumber_1138,asemeDeclaration_1177,asemeDeclaration_1241,asemeDeclaration_1246,asemeDeclaration_1248,asemeDeclaration_1250,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_1250 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1251 skipwhite skipempty
syntax region asemeComment_1251 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1251 skipwhite skipempty
syntax match asemeComment_1251 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1251 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_1068
syntax match asemeDeclaration_1248 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1249 skipwhite skipempty
syntax region asemeComment_1249 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1249 skipwhite skipempty
syntax match asemeComment_1249 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1249 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_1015
syntax match asemeDeclaration_1246 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_1244,asemeComment_1247 skipwhite skipempty
syntax region asemeComment_1247 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1244,asemeComment_1247 skipwhite skipempty
syntax match asemeComment_1247 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1244,asemeComment_1247 skipwhite skipempty
syntax match asemeName_1244 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1243,asemeComment_1245 skipwhite skipempty
syntax region asemeComment_1245 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1243,asemeComment_1245 skipwhite skipempty
syntax match asemeComment_1245 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1243,asemeComment_1245 skipwhite skipempty
syntax match asemeOperator_1243 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeDeclaration_1241 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_1240,asemeComment_1242 skipwhite skipempty
syntax region asemeComment_1242 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1240,asemeComment_1242 skipwhite skipempty
syntax match asemeComment_1242 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1240,asemeComment_1242 skipwhite skipempty
syntax match asemeName_1240 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemeClause_1182,asemeClause_1184,asemePunctuation_1188,asemeNumber_1193,asemePunctuation_1198,asemePunctuation_1201,asemePunctuation_1203,asemeOperator_1238,asemeName_1239
syntax match asemeName_1239 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeOperator_1238 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemePunctuation_1203 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemePunctuation_1201 /\v\.\./ contained nextgroup=asemeNumber_1200,asemeComment_1202 skipwhite skipempty
syntax region asemeComment_1202 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1200,asemeComment_1202 skipwhite skipempty
syntax match asemeComment_1202 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1200,asemeComment_1202 skipwhite skipempty
syntax match asemeNumber_1200 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemePunctuation_1198 /\v\:/ contained nextgroup=asemeClause_1195,asemeBuiltIn_1196,asemeType_1197,asemeComment_1199 skipwhite skipempty
syntax region asemeComment_1199 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1195,asemeBuiltIn_1196,asemeType_1197,asemeComment_1199 skipwhite skipempty
syntax match asemeComment_1199 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1195,asemeBuiltIn_1196,asemeType_1197,asemeComment_1199 skipwhite skipempty
syntax match asemeType_1197 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeBuiltIn_1196 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1195 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeNumber_1193 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1191,asemeComment_1194 skipwhite skipempty
syntax region asemeComment_1194 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1191,asemeComment_1194 skipwhite skipempty
syntax match asemeComment_1194 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1191,asemeComment_1194 skipwhite skipempty
syntax match asemePunctuation_1191 /\v\.\./ contained nextgroup=asemeNumber_1190,asemeComment_1192 skipwhite skipempty
syntax region asemeComment_1192 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1190,asemeComment_1192 skipwhite skipempty
syntax match asemeComment_1192 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1190,asemeComment_1192 skipwhite skipempty
syntax match asemeNumber_1190 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemePunctuation_1188 /\v\[/ contained nextgroup=asemeNumber_1186,asemeComment_1189 skipwhite skipempty
syntax region asemeComment_1189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1186,asemeComment_1189 skipwhite skipempty
syntax match asemeComment_1189 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1186,asemeComment_1189 skipwhite skipempty
syntax match asemeNumber_1186 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1185,asemeComment_1187 skipwhite skipempty
syntax region asemeComment_1187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1185,asemeComment_1187 skipwhite skipempty
syntax match asemeComment_1187 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1185,asemeComment_1187 skipwhite skipempty
syntax match asemePunctuation_1185 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1184 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeClause_1182 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_1179,asemeType_1181,asemeComment_1183 skipwhite skipempty
syntax region asemeComment_1183 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1179,asemeType_1181,asemeComment_1183 skipwhite skipempty
syntax match asemeComment_1183 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1179,asemeType_1181,asemeComment_1183 skipwhite skipempty
syntax match asemeType_1181 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeBuiltIn_1179 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax region asemeComment_1180 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeComment_1180 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1180 skipwhite skipempty
syntax match asemeDeclaration_1177 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_1175,asemeComment_1178 skipwhite skipempty
syntax region asemeComment_1178 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1175,asemeComment_1178 skipwhite skipempty
syntax match asemeComment_1178 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1175,asemeComment_1178 skipwhite skipempty
syntax match asemeNumber_1175 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1174,asemeComment_1176 skipwhite skipempty
syntax region asemeComment_1176 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1174,asemeComment_1176 skipwhite skipempty
syntax match asemeComment_1176 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1174,asemeComment_1176 skipwhite skipempty
syntax match asemePunctuation_1174 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeNumber_1138 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_1136,asemeComment_1139 skipwhite skipempty
syntax region asemeComment_1139 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1136,asemeComment_1139 skipwhite skipempty
syntax match asemeComment_1139 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1136,asemeComment_1139 skipwhite skipempty
syntax match asemeOperator_1136 /\v\-\>/ contained nextgroup=asemeNumber_1134,asemeComment_1137 skipwhite skipempty
syntax region asemeComment_1137 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1134,asemeComment_1137 skipwhite skipempty
syntax match asemeComment_1137 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1134,asemeComment_1137 skipwhite skipempty
syntax match asemeNumber_1134 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1133,asemeComment_1135 skipwhite skipempty
syntax region asemeComment_1135 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1133,asemeComment_1135 skipwhite skipempty
syntax match asemeComment_1135 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1133,asemeComment_1135 skipwhite skipempty
syntax match asemePunctuation_1133 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeDeclaration_1131 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_1129,asemeComment_1132 skipwhite skipempty
syntax region asemeComment_1132 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1129,asemeComment_1132 skipwhite skipempty
syntax match asemeComment_1132 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1129,asemeComment_1132 skipwhite skipempty
syntax match asemeNumber_1129 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1127,asemeComment_1130 skipwhite skipempty
syntax region asemeComment_1130 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1127,asemeComment_1130 skipwhite skipempty
syntax match asemeComment_1130 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1127,asemeComment_1130 skipwhite skipempty
syntax match asemeChoice_1127 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1125,asemeText_1126,@asemeChartNodeInBodyOfStatechart,asemeComment_1128 skipwhite skipempty
syntax region asemeComment_1128 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1125,asemeText_1126,@asemeChartNodeInBodyOfStatechart,asemeComment_1128 skipwhite skipempty
syntax match asemeComment_1128 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1125,asemeText_1126,@asemeChartNodeInBodyOfStatechart,asemeComment_1128 skipwhite skipempty
syntax match asemeText_1126 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeName_1125 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_1111,asemeChoice_1115,asemeNumber_1121,asemeName_1123,asemeText_1124
syntax match asemeText_1124 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeName_1123 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeNumber_1121 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1119,asemeComment_1122 skipwhite skipempty
syntax region asemeComment_1122 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1119,asemeComment_1122 skipwhite skipempty
syntax match asemeComment_1122 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1119,asemeComment_1122 skipwhite skipempty
syntax match asemeChoice_1119 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1117,asemeText_1118,@asemeChartNodeInBodyOfStatechart,asemeComment_1120 skipwhite skipempty
syntax region asemeComment_1120 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1117,asemeText_1118,@asemeChartNodeInBodyOfStatechart,asemeComment_1120 skipwhite skipempty
syntax match asemeComment_1120 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1117,asemeText_1118,@asemeChartNodeInBodyOfStatechart,asemeComment_1120 skipwhite skipempty
syntax match asemeText_1118 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeName_1117 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeChoice_1115 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1113,asemeText_1114,@asemeChartNodeInBodyOfStatechart,asemeComment_1116 skipwhite skipempty
syntax region asemeComment_1116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1113,asemeText_1114,@asemeChartNodeInBodyOfStatechart,asemeComment_1116 skipwhite skipempty
syntax match asemeComment_1116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1113,asemeText_1114,@asemeChartNodeInBodyOfStatechart,asemeComment_1116 skipwhite skipempty
syntax match asemeText_1114 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeName_1113 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeClause_1111 /\vactivity%(<|>)/ contained nextgroup=asemeReference_1109,asemeComment_1112 skipwhite skipempty
syntax region asemeComment_1112 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1109,asemeComment_1112 skipwhite skipempty
syntax match asemeComment_1112 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1109,asemeComment_1112 skipwhite skipempty
syntax match asemeReference_1109 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax region asemeComment_1110 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeComment_1110 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1110 skipwhite skipempty
syntax match asemeDeclaration_1107 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_1106,asemeComment_1108 skipwhite skipempty
syntax region asemeComment_1108 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1106,asemeComment_1108 skipwhite skipempty
syntax match asemeComment_1108 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1106,asemeComment_1108 skipwhite skipempty
syntax match asemeBlock_1106 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_727 skipwhite skipempty
syntax match asemeDeclaration_1104 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_1102,asemeComment_1105 skipwhite skipempty
syntax region asemeComment_1105 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1102,asemeComment_1105 skipwhite skipempty
syntax match asemeComment_1105 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1102,asemeComment_1105 skipwhite skipempty
syntax match asemeClause_1102 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_1101,asemeComment_1103 skipwhite skipempty
syntax region asemeComment_1103 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1101,asemeComment_1103 skipwhite skipempty
syntax match asemeComment_1103 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1101,asemeComment_1103 skipwhite skipempty
syntax match asemeBlock_1101 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_727 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_728,asemePunctuation_1099,asemeBlock_1100
syntax match asemeBlock_1100 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_727 skipwhite skipempty
syntax region asemePunctuation_1099 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_736,asemeDeclaration_838,asemeDeclaration_854,asemeDeclaration_918,asemeDeclaration_923,asemeDeclaration_947,asemeDeclaration_1016,asemeDeclaration_1069,asemeDeclaration_1078,asemeDeclaration_1097,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_1097 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_1095,asemeComment_1098 skipwhite skipempty
syntax region asemeComment_1098 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1095,asemeComment_1098 skipwhite skipempty
syntax match asemeComment_1098 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1095,asemeComment_1098 skipwhite skipempty
syntax match asemeBlock_1095 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1092,asemeOperator_1094,@asemeControlInBodyOfSrm,asemeComment_1096 skipwhite skipempty
syntax region asemeComment_1096 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1092,asemeOperator_1094,@asemeControlInBodyOfSrm,asemeComment_1096 skipwhite skipempty
syntax match asemeComment_1096 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1092,asemeOperator_1094,@asemeControlInBodyOfSrm,asemeComment_1096 skipwhite skipempty
syntax match asemeOperator_1094 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax match asemeOperator_1092 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1091,@asemeControlInBodyOfSrm,asemeComment_1093 skipwhite skipempty
syntax region asemeComment_1093 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1091,@asemeControlInBodyOfSrm,asemeComment_1093 skipwhite skipempty
syntax match asemeComment_1093 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1091,@asemeControlInBodyOfSrm,asemeComment_1093 skipwhite skipempty
syntax match asemeOperator_1091 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemeOperator_1082,asemePunctuation_704,asemeOperator_1084,asemeBlock_1089
syntax match asemeBlock_1089 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1086,asemeOperator_1088,@asemeControlInBodyOfSrm,asemeComment_1090 skipwhite skipempty
syntax region asemeComment_1090 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1086,asemeOperator_1088,@asemeControlInBodyOfSrm,asemeComment_1090 skipwhite skipempty
syntax match asemeComment_1090 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1086,asemeOperator_1088,@asemeControlInBodyOfSrm,asemeComment_1090 skipwhite skipempty
syntax match asemeOperator_1088 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax match asemeOperator_1086 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1085,@asemeControlInBodyOfSrm,asemeComment_1087 skipwhite skipempty
syntax region asemeComment_1087 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1085,@asemeControlInBodyOfSrm,asemeComment_1087 skipwhite skipempty
syntax match asemeComment_1087 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1085,@asemeControlInBodyOfSrm,asemeComment_1087 skipwhite skipempty
syntax match asemeOperator_1085 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax match asemeOperator_1084 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax match asemeOperator_1082 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1080,@asemeControlInBodyOfSrm,asemeComment_1083 skipwhite skipempty
syntax region asemeComment_1083 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1080,@asemeControlInBodyOfSrm,asemeComment_1083 skipwhite skipempty
syntax match asemeComment_1083 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1080,@asemeControlInBodyOfSrm,asemeComment_1083 skipwhite skipempty
syntax match asemeOperator_1080 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax region asemeComment_1081 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax match asemeComment_1081 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1081 skipwhite skipempty
syntax match asemeDeclaration_1078 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_1077,asemeComment_1079 skipwhite skipempty
syntax region asemeComment_1079 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1077,asemeComment_1079 skipwhite skipempty
syntax match asemeComment_1079 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1077,asemeComment_1079 skipwhite skipempty
syntax match asemeBlock_1077 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_1074,asemeBlock_1075
syntax match asemeBlock_1075 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax region asemeComment_1076 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax match asemeComment_1076 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1076 skipwhite skipempty
syntax region asemePunctuation_1074 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_1072,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_1072 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_1071,asemeComment_1073 skipwhite skipempty
syntax region asemeComment_1073 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1071,asemeComment_1073 skipwhite skipempty
syntax match asemeComment_1073 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1071,asemeComment_1073 skipwhite skipempty
syntax match asemeText_1071 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1069 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax region asemeComment_1070 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax match asemeComment_1070 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1070 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_1068
syntax region asemePunctuation_1068 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_1067,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_1067 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_1023,asemeClause_1026,asemeClause_1029,asemeClause_1032,asemeClause_1035,asemeClause_1038,asemeChoice_1041,asemeClause_1044,asemeClause_1047,asemeClause_1050,asemeClause_1052,asemeChoice_1053,asemeChoice_1054,asemePunctuation_1061,asemeOperator_1064,asemeReference_1066
syntax match asemeReference_1066 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeOperator_1064 /\v\=%(\=)@!/ contained nextgroup=asemeText_1063,asemeComment_1065 skipwhite skipempty
syntax region asemeComment_1065 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1063,asemeComment_1065 skipwhite skipempty
syntax match asemeComment_1065 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1063,asemeComment_1065 skipwhite skipempty
syntax match asemeText_1063 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemePunctuation_1061 /\v\,/ contained nextgroup=asemeChoice_1056,asemeReference_1058,asemeReference_1059,asemeReference_1060,asemeComment_1062 skipwhite skipempty
syntax region asemeComment_1062 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1056,asemeReference_1058,asemeReference_1059,asemeReference_1060,asemeComment_1062 skipwhite skipempty
syntax match asemeComment_1062 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1056,asemeReference_1058,asemeReference_1059,asemeReference_1060,asemeComment_1062 skipwhite skipempty
syntax match asemeReference_1060 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeReference_1059 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeReference_1058 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeChoice_1056 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1055,asemeComment_1057 skipwhite skipempty
syntax region asemeComment_1057 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1055,asemeComment_1057 skipwhite skipempty
syntax match asemeComment_1057 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1055,asemeComment_1057 skipwhite skipempty
syntax match asemeReference_1055 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeChoice_1054 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeChoice_1053 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1052 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1050 /\vends%(<|>)/ contained nextgroup=asemeReference_1049,asemeComment_1051 skipwhite skipempty
syntax region asemeComment_1051 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1049,asemeComment_1051 skipwhite skipempty
syntax match asemeComment_1051 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1049,asemeComment_1051 skipwhite skipempty
syntax match asemeReference_1049 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1047 /\vwrites%(<|>)/ contained nextgroup=asemeReference_1046,asemeComment_1048 skipwhite skipempty
syntax region asemeComment_1048 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1046,asemeComment_1048 skipwhite skipempty
syntax match asemeComment_1048 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1046,asemeComment_1048 skipwhite skipempty
syntax match asemeReference_1046 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1044 /\vfor%(<|>)/ contained nextgroup=asemeNumber_1043,asemeComment_1045 skipwhite skipempty
syntax region asemeComment_1045 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1043,asemeComment_1045 skipwhite skipempty
syntax match asemeComment_1045 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1043,asemeComment_1045 skipwhite skipempty
syntax match asemeNumber_1043 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeChoice_1041 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1040,asemeComment_1042 skipwhite skipempty
syntax region asemeComment_1042 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1040,asemeComment_1042 skipwhite skipempty
syntax match asemeComment_1042 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1040,asemeComment_1042 skipwhite skipempty
syntax match asemeReference_1040 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1038 /\vuses%(<|>)/ contained nextgroup=asemeReference_1037,asemeComment_1039 skipwhite skipempty
syntax region asemeComment_1039 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1037,asemeComment_1039 skipwhite skipempty
syntax match asemeComment_1039 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1037,asemeComment_1039 skipwhite skipempty
syntax match asemeReference_1037 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1035 /\vas%(<|>)/ contained nextgroup=asemeChoice_1034,asemeComment_1036 skipwhite skipempty
syntax region asemeComment_1036 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1034,asemeComment_1036 skipwhite skipempty
syntax match asemeComment_1036 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1034,asemeComment_1036 skipwhite skipempty
syntax match asemeChoice_1034 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1032 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_1031,asemeComment_1033 skipwhite skipempty
syntax region asemeComment_1033 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1031,asemeComment_1033 skipwhite skipempty
syntax match asemeComment_1033 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1031,asemeComment_1033 skipwhite skipempty
syntax match asemeNumber_1031 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1029 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_1028,asemeComment_1030 skipwhite skipempty
syntax region asemeComment_1030 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1028,asemeComment_1030 skipwhite skipempty
syntax match asemeComment_1030 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1028,asemeComment_1030 skipwhite skipempty
syntax match asemeNumber_1028 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1026 /\vevery%(<|>)/ contained nextgroup=asemeNumber_1025,asemeComment_1027 skipwhite skipempty
syntax region asemeComment_1027 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1025,asemeComment_1027 skipwhite skipempty
syntax match asemeComment_1027 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1025,asemeComment_1027 skipwhite skipempty
syntax match asemeNumber_1025 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeClause_1023 /\vreads%(<|>)/ contained nextgroup=asemeChoice_1020,asemeReference_1022,asemeComment_1024 skipwhite skipempty
syntax region asemeComment_1024 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1020,asemeReference_1022,asemeComment_1024 skipwhite skipempty
syntax match asemeComment_1024 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1020,asemeReference_1022,asemeComment_1024 skipwhite skipempty
syntax match asemeReference_1022 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeChoice_1020 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1018,asemeComment_1021 skipwhite skipempty
syntax region asemeComment_1021 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1018,asemeComment_1021 skipwhite skipempty
syntax match asemeComment_1021 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1018,asemeComment_1021 skipwhite skipempty
syntax match asemeReference_1018 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax region asemeComment_1019 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeComment_1019 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_1019 skipwhite skipempty
syntax match asemeDeclaration_1016 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_1017 skipwhite skipempty
syntax region asemeComment_1017 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_1017 skipwhite skipempty
syntax match asemeComment_1017 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_1017 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_1015
syntax region asemePunctuation_1015 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_1014,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_1014 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_954,asemeClause_957,asemeClause_960,asemeClause_963,asemeClause_966,asemeClause_969,asemeChoice_972,asemeClause_975,asemeClause_978,asemeClause_981,asemeClause_983,asemeChoice_984,asemeChoice_985,asemePunctuation_992,asemePunctuation_1006,asemePunctuation_1010,asemePunctuation_1012,asemeReference_1013
syntax match asemeReference_1013 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemePunctuation_1012 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemePunctuation_1010 /\v\:/ contained nextgroup=asemeBuiltIn_1008,asemeType_1009,asemeComment_1011 skipwhite skipempty
syntax region asemeComment_1011 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1008,asemeType_1009,asemeComment_1011 skipwhite skipempty
syntax match asemeComment_1011 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1008,asemeType_1009,asemeComment_1011 skipwhite skipempty
syntax match asemeType_1009 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeBuiltIn_1008 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemePunctuation_1006 /\v\,/ contained nextgroup=asemeName_998,asemeChoice_1001,asemeReference_1003,asemeReference_1004,asemeReference_1005,asemeComment_1007 skipwhite skipempty
syntax region asemeComment_1007 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_998,asemeChoice_1001,asemeReference_1003,asemeReference_1004,asemeReference_1005,asemeComment_1007 skipwhite skipempty
syntax match asemeComment_1007 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_998,asemeChoice_1001,asemeReference_1003,asemeReference_1004,asemeReference_1005,asemeComment_1007 skipwhite skipempty
syntax match asemeReference_1005 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeReference_1004 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeReference_1003 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeChoice_1001 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1000,asemeComment_1002 skipwhite skipempty
syntax region asemeComment_1002 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1000,asemeComment_1002 skipwhite skipempty
syntax match asemeComment_1002 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1000,asemeComment_1002 skipwhite skipempty
syntax match asemeReference_1000 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeName_998 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_996,asemeComment_999 skipwhite skipempty
syntax region asemeComment_999 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_996,asemeComment_999 skipwhite skipempty
syntax match asemeComment_999 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_996,asemeComment_999 skipwhite skipempty
syntax match asemePunctuation_996 /\v\:/ contained nextgroup=asemeBuiltIn_994,asemeType_995,asemeComment_997 skipwhite skipempty
syntax region asemeComment_997 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_994,asemeType_995,asemeComment_997 skipwhite skipempty
syntax match asemeComment_997 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_994,asemeType_995,asemeComment_997 skipwhite skipempty
syntax match asemeType_995 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeBuiltIn_994 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemePunctuation_992 /\v\(/ contained nextgroup=asemeName_990,asemeComment_993 skipwhite skipempty
syntax region asemeComment_993 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_990,asemeComment_993 skipwhite skipempty
syntax match asemeComment_993 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_990,asemeComment_993 skipwhite skipempty
syntax match asemeName_990 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_988,asemeComment_991 skipwhite skipempty
syntax region asemeComment_991 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_988,asemeComment_991 skipwhite skipempty
syntax match asemeComment_991 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_988,asemeComment_991 skipwhite skipempty
syntax match asemePunctuation_988 /\v\:/ contained nextgroup=asemeBuiltIn_986,asemeType_987,asemeComment_989 skipwhite skipempty
syntax region asemeComment_989 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_986,asemeType_987,asemeComment_989 skipwhite skipempty
syntax match asemeComment_989 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_986,asemeType_987,asemeComment_989 skipwhite skipempty
syntax match asemeType_987 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeBuiltIn_986 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeChoice_985 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeChoice_984 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_983 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_981 /\vends%(<|>)/ contained nextgroup=asemeReference_980,asemeComment_982 skipwhite skipempty
syntax region asemeComment_982 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_980,asemeComment_982 skipwhite skipempty
syntax match asemeComment_982 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_980,asemeComment_982 skipwhite skipempty
syntax match asemeReference_980 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_978 /\vwrites%(<|>)/ contained nextgroup=asemeReference_977,asemeComment_979 skipwhite skipempty
syntax region asemeComment_979 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_977,asemeComment_979 skipwhite skipempty
syntax match asemeComment_979 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_977,asemeComment_979 skipwhite skipempty
syntax match asemeReference_977 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_975 /\vfor%(<|>)/ contained nextgroup=asemeNumber_974,asemeComment_976 skipwhite skipempty
syntax region asemeComment_976 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_974,asemeComment_976 skipwhite skipempty
syntax match asemeComment_976 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_974,asemeComment_976 skipwhite skipempty
syntax match asemeNumber_974 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeChoice_972 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_971,asemeComment_973 skipwhite skipempty
syntax region asemeComment_973 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_971,asemeComment_973 skipwhite skipempty
syntax match asemeComment_973 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_971,asemeComment_973 skipwhite skipempty
syntax match asemeReference_971 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_969 /\vuses%(<|>)/ contained nextgroup=asemeReference_968,asemeComment_970 skipwhite skipempty
syntax region asemeComment_970 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_968,asemeComment_970 skipwhite skipempty
syntax match asemeComment_970 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_968,asemeComment_970 skipwhite skipempty
syntax match asemeReference_968 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_966 /\vas%(<|>)/ contained nextgroup=asemeChoice_965,asemeComment_967 skipwhite skipempty
syntax region asemeComment_967 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_965,asemeComment_967 skipwhite skipempty
syntax match asemeComment_967 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_965,asemeComment_967 skipwhite skipempty
syntax match asemeChoice_965 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_963 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_962,asemeComment_964 skipwhite skipempty
syntax region asemeComment_964 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_962,asemeComment_964 skipwhite skipempty
syntax match asemeComment_964 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_962,asemeComment_964 skipwhite skipempty
syntax match asemeNumber_962 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_960 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_959,asemeComment_961 skipwhite skipempty
syntax region asemeComment_961 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_959,asemeComment_961 skipwhite skipempty
syntax match asemeComment_961 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_959,asemeComment_961 skipwhite skipempty
syntax match asemeNumber_959 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_957 /\vevery%(<|>)/ contained nextgroup=asemeNumber_956,asemeComment_958 skipwhite skipempty
syntax region asemeComment_958 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_956,asemeComment_958 skipwhite skipempty
syntax match asemeComment_958 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_956,asemeComment_958 skipwhite skipempty
syntax match asemeNumber_956 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeClause_954 /\vreads%(<|>)/ contained nextgroup=asemeChoice_951,asemeReference_953,asemeComment_955 skipwhite skipempty
syntax region asemeComment_955 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_951,asemeReference_953,asemeComment_955 skipwhite skipempty
syntax match asemeComment_955 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_951,asemeReference_953,asemeComment_955 skipwhite skipempty
syntax match asemeReference_953 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeChoice_951 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_949,asemeComment_952 skipwhite skipempty
syntax region asemeComment_952 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_949,asemeComment_952 skipwhite skipempty
syntax match asemeComment_952 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_949,asemeComment_952 skipwhite skipempty
syntax match asemeReference_949 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax region asemeComment_950 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeComment_950 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_950 skipwhite skipempty
syntax match asemeDeclaration_947 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_948 skipwhite skipempty
syntax region asemeComment_948 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_948 skipwhite skipempty
syntax match asemeComment_948 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_948 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_946
syntax region asemePunctuation_946 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_945,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_945 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_927,asemePunctuation_931,asemePunctuation_934,asemePunctuation_936,asemeOperator_944
syntax match asemeOperator_944 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemePunctuation_936 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax match asemePunctuation_934 /\v\,/ contained nextgroup=asemeName_933,asemeComment_935 skipwhite skipempty
syntax region asemeComment_935 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_933,asemeComment_935 skipwhite skipempty
syntax match asemeComment_935 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_933,asemeComment_935 skipwhite skipempty
syntax match asemeName_933 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax match asemePunctuation_931 /\v\:/ contained nextgroup=asemeBuiltIn_929,asemeType_930,asemeComment_932 skipwhite skipempty
syntax region asemeComment_932 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_929,asemeType_930,asemeComment_932 skipwhite skipempty
syntax match asemeComment_932 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_929,asemeType_930,asemeComment_932 skipwhite skipempty
syntax match asemeType_930 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax match asemeBuiltIn_929 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax match asemePunctuation_927 /\v\(/ contained nextgroup=asemeName_925,asemeComment_928 skipwhite skipempty
syntax region asemeComment_928 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_925,asemeComment_928 skipwhite skipempty
syntax match asemeComment_928 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_925,asemeComment_928 skipwhite skipempty
syntax match asemeName_925 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax region asemeComment_926 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax match asemeComment_926 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_926 skipwhite skipempty
syntax match asemeDeclaration_923 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_921,asemeComment_924 skipwhite skipempty
syntax region asemeComment_924 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_921,asemeComment_924 skipwhite skipempty
syntax match asemeComment_924 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_921,asemeComment_924 skipwhite skipempty
syntax match asemeName_921 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_920,asemeComment_922 skipwhite skipempty
syntax region asemeComment_922 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_920,asemeComment_922 skipwhite skipempty
syntax match asemeComment_922 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_920,asemeComment_922 skipwhite skipempty
syntax match asemeOperator_920 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeDeclaration_918 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_917,asemeComment_919 skipwhite skipempty
syntax region asemeComment_919 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_917,asemeComment_919 skipwhite skipempty
syntax match asemeComment_919 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_917,asemeComment_919 skipwhite skipempty
syntax match asemeName_917 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemeClause_859,asemeClause_861,asemePunctuation_865,asemeNumber_870,asemePunctuation_875,asemePunctuation_878,asemePunctuation_880,asemeOperator_915,asemeName_916
syntax match asemeName_916 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeOperator_915 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemePunctuation_880 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemePunctuation_878 /\v\.\./ contained nextgroup=asemeNumber_877,asemeComment_879 skipwhite skipempty
syntax region asemeComment_879 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_877,asemeComment_879 skipwhite skipempty
syntax match asemeComment_879 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_877,asemeComment_879 skipwhite skipempty
syntax match asemeNumber_877 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemePunctuation_875 /\v\:/ contained nextgroup=asemeClause_872,asemeBuiltIn_873,asemeType_874,asemeComment_876 skipwhite skipempty
syntax region asemeComment_876 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_872,asemeBuiltIn_873,asemeType_874,asemeComment_876 skipwhite skipempty
syntax match asemeComment_876 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_872,asemeBuiltIn_873,asemeType_874,asemeComment_876 skipwhite skipempty
syntax match asemeType_874 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeBuiltIn_873 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeClause_872 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeNumber_870 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_868,asemeComment_871 skipwhite skipempty
syntax region asemeComment_871 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_868,asemeComment_871 skipwhite skipempty
syntax match asemeComment_871 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_868,asemeComment_871 skipwhite skipempty
syntax match asemePunctuation_868 /\v\.\./ contained nextgroup=asemeNumber_867,asemeComment_869 skipwhite skipempty
syntax region asemeComment_869 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_867,asemeComment_869 skipwhite skipempty
syntax match asemeComment_869 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_867,asemeComment_869 skipwhite skipempty
syntax match asemeNumber_867 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemePunctuation_865 /\v\[/ contained nextgroup=asemeNumber_863,asemeComment_866 skipwhite skipempty
syntax region asemeComment_866 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_863,asemeComment_866 skipwhite skipempty
syntax match asemeComment_866 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_863,asemeComment_866 skipwhite skipempty
syntax match asemeNumber_863 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax region asemeComment_864 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax match asemeComment_864 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_862,asemeComment_864 skipwhite skipempty
syntax match asemePunctuation_862 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeClause_861 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeClause_859 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_856,asemeType_858,asemeComment_860 skipwhite skipempty
syntax region asemeComment_860 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_856,asemeType_858,asemeComment_860 skipwhite skipempty
syntax match asemeComment_860 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_856,asemeType_858,asemeComment_860 skipwhite skipempty
syntax match asemeType_858 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeBuiltIn_856 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax region asemeComment_857 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeComment_857 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_857 skipwhite skipempty
syntax match asemeDeclaration_854 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_852,asemeComment_855 skipwhite skipempty
syntax region asemeComment_855 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_852,asemeComment_855 skipwhite skipempty
syntax match asemeComment_855 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_852,asemeComment_855 skipwhite skipempty
syntax match asemeName_852 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_851,@asemeCapabilityInBodyOfSrm,asemeComment_853 skipwhite skipempty
syntax region asemeComment_853 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_851,@asemeCapabilityInBodyOfSrm,asemeComment_853 skipwhite skipempty
syntax match asemeComment_853 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_851,@asemeCapabilityInBodyOfSrm,asemeComment_853 skipwhite skipempty
syntax match asemeText_851 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_842,asemePunctuation_845,asemeText_847,asemeName_849
syntax match asemeName_849 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_848,@asemeCapabilityInBodyOfSrm,asemeComment_850 skipwhite skipempty
syntax region asemeComment_850 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_848,@asemeCapabilityInBodyOfSrm,asemeComment_850 skipwhite skipempty
syntax match asemeComment_850 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_848,@asemeCapabilityInBodyOfSrm,asemeComment_850 skipwhite skipempty
syntax match asemeText_848 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax match asemeText_847 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax match asemePunctuation_845 /\v\,/ contained nextgroup=asemeReference_844,asemeComment_846 skipwhite skipempty
syntax region asemeComment_846 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_844,asemeComment_846 skipwhite skipempty
syntax match asemeComment_846 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_844,asemeComment_846 skipwhite skipempty
syntax match asemeReference_844 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax match asemeOperator_842 /\v\=%(\=)@!/ contained nextgroup=asemeReference_840,asemeComment_843 skipwhite skipempty
syntax region asemeComment_843 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_840,asemeComment_843 skipwhite skipempty
syntax match asemeComment_843 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_840,asemeComment_843 skipwhite skipempty
syntax match asemeReference_840 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax region asemeComment_841 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax match asemeComment_841 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_841 skipwhite skipempty
syntax match asemeDeclaration_838 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_836,asemeComment_839 skipwhite skipempty
syntax region asemeComment_839 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_836,asemeComment_839 skipwhite skipempty
syntax match asemeComment_839 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_836,asemeComment_839 skipwhite skipempty
syntax match asemeReference_836 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_834,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_834,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_834,asemeComment_837 skipwhite skipempty
syntax match asemePunctuation_834 /\v\./ contained nextgroup=asemeReference_833,asemeComment_835 skipwhite skipempty
syntax region asemeComment_835 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_833,asemeComment_835 skipwhite skipempty
syntax match asemeComment_835 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_833,asemeComment_835 skipwhite skipempty
syntax match asemeReference_833 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_775,asemeClause_779,asemeClause_810,asemeClause_812,asemePunctuation_821,asemePunctuation_824,asemeOperator_826,asemeReference_830,asemeReference_832
syntax match asemeReference_832 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax match asemeReference_830 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_828,asemeComment_831 skipwhite skipempty
syntax region asemeComment_831 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_828,asemeComment_831 skipwhite skipempty
syntax match asemeComment_831 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_828,asemeComment_831 skipwhite skipempty
syntax match asemePunctuation_828 /\v\./ contained nextgroup=asemeReference_827,asemeComment_829 skipwhite skipempty
syntax region asemeComment_829 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_827,asemeComment_829 skipwhite skipempty
syntax match asemeComment_829 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_827,asemeComment_829 skipwhite skipempty
syntax match asemeReference_827 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax match asemeOperator_826 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemePunctuation_824 /\v\./ contained nextgroup=asemeReference_823,asemeComment_825 skipwhite skipempty
syntax region asemeComment_825 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_823,asemeComment_825 skipwhite skipempty
syntax match asemeComment_825 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_823,asemeComment_825 skipwhite skipempty
syntax match asemeReference_823 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax match asemePunctuation_821 /\v\,/ contained nextgroup=asemeReference_816,asemeReference_819,asemeComment_822 skipwhite skipempty
syntax region asemeComment_822 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_816,asemeReference_819,asemeComment_822 skipwhite skipempty
syntax match asemeComment_822 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_816,asemeReference_819,asemeComment_822 skipwhite skipempty
syntax match asemeReference_819 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_818,asemeComment_820 skipwhite skipempty
syntax region asemeComment_820 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_818,asemeComment_820 skipwhite skipempty
syntax match asemeComment_820 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_818,asemeComment_820 skipwhite skipempty
syntax match asemeOperator_818 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeReference_816 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_814,asemeComment_817 skipwhite skipempty
syntax region asemeComment_817 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_814,asemeComment_817 skipwhite skipempty
syntax match asemeComment_817 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_814,asemeComment_817 skipwhite skipempty
syntax match asemePunctuation_814 /\v\./ contained nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax region asemeComment_815 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax match asemeComment_815 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_813,asemeComment_815 skipwhite skipempty
syntax match asemeReference_813 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax match asemeClause_812 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_810 /\vwhen%(<|>)/ contained nextgroup=asemeClause_809,asemeComment_811 skipwhite skipempty
syntax region asemeComment_811 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_809,asemeComment_811 skipwhite skipempty
syntax match asemeComment_811 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_809,asemeComment_811 skipwhite skipempty
syntax match asemeClause_809 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_779 /\vas%(<|>)/ contained nextgroup=asemeReference_777,asemeComment_780 skipwhite skipempty
syntax region asemeComment_780 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_777,asemeComment_780 skipwhite skipempty
syntax match asemeComment_780 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_777,asemeComment_780 skipwhite skipempty
syntax match asemeReference_777 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax region asemeComment_778 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax match asemeComment_778 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_778 skipwhite skipempty
syntax match asemeClause_775 /\vwith%(<|>)/ contained nextgroup=asemeReference_773,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_773,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_773,asemeComment_776 skipwhite skipempty
syntax match asemeReference_773 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_772,asemeComment_774 skipwhite skipempty
syntax region asemeComment_774 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_772,asemeComment_774 skipwhite skipempty
syntax match asemeComment_774 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_772,asemeComment_774 skipwhite skipempty
syntax match asemeOperator_772 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeDeclaration_736 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_735,asemeComment_737 skipwhite skipempty
syntax region asemeComment_737 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_735,asemeComment_737 skipwhite skipempty
syntax match asemeComment_737 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_735,asemeComment_737 skipwhite skipempty
syntax match asemeReference_735 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_732,asemeReference_734
syntax match asemeReference_734 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemePunctuation_732 /\v\,/ contained nextgroup=asemeReference_730,asemeComment_733 skipwhite skipempty
syntax region asemeComment_733 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_730,asemeComment_733 skipwhite skipempty
syntax match asemeComment_733 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_730,asemeComment_733 skipwhite skipempty
syntax match asemeReference_730 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeClause_728 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_726,asemeComment_729 skipwhite skipempty
syntax region asemeComment_729 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_726,asemeComment_729 skipwhite skipempty
syntax match asemeComment_729 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_726,asemeComment_729 skipwhite skipempty
syntax match asemeBlock_726 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_727 skipwhite skipempty
syntax region asemeComment_727 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_727 skipwhite skipempty
syntax match asemeComment_727 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_727 skipwhite skipempty
syntax match asemeDeclaration_724 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_723,asemeComment_725 skipwhite skipempty
syntax region asemeComment_725 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_723,asemeComment_725 skipwhite skipempty
syntax match asemeComment_725 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_723,asemeComment_725 skipwhite skipempty
syntax match asemeBlock_723 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_722 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_720,asemeBlock_721
syntax match asemeBlock_721 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_722 skipwhite skipempty
syntax region asemeComment_722 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_722 skipwhite skipempty
syntax match asemeComment_722 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_722 skipwhite skipempty
syntax region asemePunctuation_720 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_568,asemeDeclaration_571,asemeDeclaration_604,asemeDeclaration_608,asemeDeclaration_718,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_718 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_716,asemeComment_719 skipwhite skipempty
syntax region asemeComment_719 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_716,asemeComment_719 skipwhite skipempty
syntax match asemeComment_719 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_716,asemeComment_719 skipwhite skipempty
syntax match asemeBlock_716 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_713,asemeOperator_715,@asemeControlInBodyOfAip,asemeComment_717 skipwhite skipempty
syntax region asemeComment_717 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_713,asemeOperator_715,@asemeControlInBodyOfAip,asemeComment_717 skipwhite skipempty
syntax match asemeComment_717 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_713,asemeOperator_715,@asemeControlInBodyOfAip,asemeComment_717 skipwhite skipempty
syntax match asemeOperator_715 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax match asemeOperator_713 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_712,@asemeControlInBodyOfAip,asemeComment_714 skipwhite skipempty
syntax region asemeComment_714 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_712,@asemeControlInBodyOfAip,asemeComment_714 skipwhite skipempty
syntax match asemeComment_714 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_712,@asemeControlInBodyOfAip,asemeComment_714 skipwhite skipempty
syntax match asemeOperator_712 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemeOperator_612,asemePunctuation_704,asemeOperator_705,asemeBlock_710
syntax match asemeBlock_710 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_707,asemeOperator_709,@asemeControlInBodyOfAip,asemeComment_711 skipwhite skipempty
syntax region asemeComment_711 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_707,asemeOperator_709,@asemeControlInBodyOfAip,asemeComment_711 skipwhite skipempty
syntax match asemeComment_711 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_707,asemeOperator_709,@asemeControlInBodyOfAip,asemeComment_711 skipwhite skipempty
syntax match asemeOperator_709 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax match asemeOperator_707 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_706,@asemeControlInBodyOfAip,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_706,@asemeControlInBodyOfAip,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_706,@asemeControlInBodyOfAip,asemeComment_708 skipwhite skipempty
syntax match asemeOperator_706 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax match asemeOperator_705 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax region asemePunctuation_704 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_662,asemeNumber_702,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeNumber_702 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_700,asemeComment_703 skipwhite skipempty
syntax region asemeComment_703 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_700,asemeComment_703 skipwhite skipempty
syntax match asemeComment_703 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_700,asemeComment_703 skipwhite skipempty
syntax match asemeOperator_700 /\v\-\>/ contained nextgroup=asemeNumber_698,asemeComment_701 skipwhite skipempty
syntax region asemeComment_701 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_698,asemeComment_701 skipwhite skipempty
syntax match asemeComment_701 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_698,asemeComment_701 skipwhite skipempty
syntax match asemeNumber_698 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_697,asemeComment_699 skipwhite skipempty
syntax region asemeComment_699 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_697,asemeComment_699 skipwhite skipempty
syntax match asemeComment_699 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_697,asemeComment_699 skipwhite skipempty
syntax match asemePunctuation_697 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeDeclaration_662 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_616,asemeOperator_619,asemePunctuation_655,asemeText_656,asemeNumber_657,asemeReference_658,asemeNumber_659,asemeOperator_660,asemePunctuation_661
syntax match asemePunctuation_661 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeOperator_660 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeNumber_659 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeReference_658 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeNumber_657 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeText_656 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemePunctuation_655 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeOperator_619 /\v\#/ contained nextgroup=asemeNumber_618,asemeComment_620 skipwhite skipempty
syntax region asemeComment_620 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_618,asemeComment_620 skipwhite skipempty
syntax match asemeComment_620 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_618,asemeComment_620 skipwhite skipempty
syntax match asemeNumber_618 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeClause_616 /\vevery%(<|>)/ contained nextgroup=asemeNumber_614,asemeComment_617 skipwhite skipempty
syntax region asemeComment_617 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_614,asemeComment_617 skipwhite skipempty
syntax match asemeComment_617 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_614,asemeComment_617 skipwhite skipempty
syntax match asemeNumber_614 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax region asemeComment_615 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeComment_615 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_615 skipwhite skipempty
syntax match asemeOperator_612 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_610,@asemeControlInBodyOfAip,asemeComment_613 skipwhite skipempty
syntax region asemeComment_613 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_610,@asemeControlInBodyOfAip,asemeComment_613 skipwhite skipempty
syntax match asemeComment_613 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_610,@asemeControlInBodyOfAip,asemeComment_613 skipwhite skipempty
syntax match asemeOperator_610 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax region asemeComment_611 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax match asemeComment_611 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_611 skipwhite skipempty
syntax match asemeDeclaration_608 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_606,asemeComment_609 skipwhite skipempty
syntax region asemeComment_609 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_606,asemeComment_609 skipwhite skipempty
syntax match asemeComment_609 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_606,asemeComment_609 skipwhite skipempty
syntax match asemeName_606 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_605,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_605,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_605,asemeComment_607 skipwhite skipempty
syntax match asemeOperator_605 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeDeclaration_604 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_578,asemeClause_582,asemeClause_585,asemeClause_588,asemeClause_591,asemeClause_593,asemeClause_594,asemeClause_595,asemePunctuation_597,asemeOperator_600,asemePunctuation_602,asemeName_603
syntax match asemeName_603 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemePunctuation_602 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeOperator_600 /\v\@/ contained nextgroup=asemeReference_599,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_599,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_599,asemeComment_601 skipwhite skipempty
syntax match asemeReference_599 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemePunctuation_597 /\v\(/ contained nextgroup=asemeName_596,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_596,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_596,asemeComment_598 skipwhite skipempty
syntax match asemeName_596 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_595 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_594 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_593 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_591 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_590,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_590,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_590,asemeComment_592 skipwhite skipempty
syntax match asemeNumber_590 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_588 /\vleads%(<|>)/ contained nextgroup=asemeClause_587,asemeComment_589 skipwhite skipempty
syntax region asemeComment_589 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_587,asemeComment_589 skipwhite skipempty
syntax match asemeComment_589 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_587,asemeComment_589 skipwhite skipempty
syntax match asemeClause_587 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_585 /\vor%(<|>)/ contained nextgroup=asemeName_584,asemeComment_586 skipwhite skipempty
syntax region asemeComment_586 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_584,asemeComment_586 skipwhite skipempty
syntax match asemeComment_586 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_584,asemeComment_586 skipwhite skipempty
syntax match asemeName_584 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_582 /\vmost%(<|>)/ contained nextgroup=asemeChoice_580,asemeNumber_581,asemeComment_583 skipwhite skipempty
syntax region asemeComment_583 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_580,asemeNumber_581,asemeComment_583 skipwhite skipempty
syntax match asemeComment_583 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_580,asemeNumber_581,asemeComment_583 skipwhite skipempty
syntax match asemeNumber_581 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeChoice_580 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeClause_578 /\vat%(<|>)/ contained nextgroup=asemeClause_576,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_576,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_576,asemeComment_579 skipwhite skipempty
syntax match asemeClause_576 /\vmost%(<|>)/ contained nextgroup=asemeChoice_573,asemeNumber_575,asemeComment_577 skipwhite skipempty
syntax region asemeComment_577 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_573,asemeNumber_575,asemeComment_577 skipwhite skipempty
syntax match asemeComment_577 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_573,asemeNumber_575,asemeComment_577 skipwhite skipempty
syntax match asemeNumber_575 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeChoice_573 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax region asemeComment_574 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeComment_574 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_574 skipwhite skipempty
syntax match asemeDeclaration_571 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_570,asemeComment_572 skipwhite skipempty
syntax region asemeComment_572 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_570,asemeComment_572 skipwhite skipempty
syntax match asemeComment_572 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_570,asemeComment_572 skipwhite skipempty
syntax match asemeText_570 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_568 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_567,asemeComment_569 skipwhite skipempty
syntax region asemeComment_569 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_567,asemeComment_569 skipwhite skipempty
syntax match asemeComment_569 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_567,asemeComment_569 skipwhite skipempty
syntax match asemeBlock_567 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_257,asemePunctuation_260,asemePunctuation_262,asemePunctuation_565,asemeBlock_566
syntax match asemeBlock_566 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax region asemePunctuation_565 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_264,asemeDeclaration_366,asemeDeclaration_430,asemeDeclaration_438,asemeDeclaration_502,asemeDeclaration_507,asemeDeclaration_528,asemeDeclaration_542,asemeName_564,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_564 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_546,asemePunctuation_550,asemePunctuation_553,asemePunctuation_555,asemeOperator_563
syntax match asemeOperator_563 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemePunctuation_555 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax match asemePunctuation_553 /\v\,/ contained nextgroup=asemeName_552,asemeComment_554 skipwhite skipempty
syntax region asemeComment_554 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_552,asemeComment_554 skipwhite skipempty
syntax match asemeComment_554 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_552,asemeComment_554 skipwhite skipempty
syntax match asemeName_552 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax match asemePunctuation_550 /\v\:/ contained nextgroup=asemeBuiltIn_548,asemeType_549,asemeComment_551 skipwhite skipempty
syntax region asemeComment_551 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_548,asemeType_549,asemeComment_551 skipwhite skipempty
syntax match asemeComment_551 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_548,asemeType_549,asemeComment_551 skipwhite skipempty
syntax match asemeType_549 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax match asemeBuiltIn_548 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax match asemePunctuation_546 /\v\(/ contained nextgroup=asemeName_544,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_544,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_544,asemeComment_547 skipwhite skipempty
syntax match asemeName_544 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax region asemeComment_545 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax match asemeComment_545 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_545 skipwhite skipempty
syntax match asemeDeclaration_542 /\v%(receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_540,asemeComment_543 skipwhite skipempty
syntax region asemeComment_543 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_540,asemeComment_543 skipwhite skipempty
syntax match asemeComment_543 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_540,asemeComment_543 skipwhite skipempty
syntax match asemeReference_540 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_539,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_539,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_539,asemeComment_541 skipwhite skipempty
syntax match asemeReference_539 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_534,asemeReference_537
syntax match asemeReference_537 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_536,@asemeReceivesInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_536,@asemeReceivesInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_536,@asemeReceivesInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeReference_536 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax match asemePunctuation_534 /\v\,/ contained nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax region asemeComment_535 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax match asemeComment_535 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax match asemeReference_532 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_530,asemeComment_533 skipwhite skipempty
syntax region asemeComment_533 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_530,asemeComment_533 skipwhite skipempty
syntax match asemeComment_533 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_530,asemeComment_533 skipwhite skipempty
syntax match asemeReference_530 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax region asemeComment_531 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax match asemeComment_531 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_531 skipwhite skipempty
syntax match asemeDeclaration_528 /\v%(sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_526,asemeComment_529 skipwhite skipempty
syntax region asemeComment_529 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_526,asemeComment_529 skipwhite skipempty
syntax match asemeComment_529 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_526,asemeComment_529 skipwhite skipempty
syntax match asemeReference_526 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_525,asemeComment_527 skipwhite skipempty
syntax region asemeComment_527 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_525,asemeComment_527 skipwhite skipempty
syntax match asemeComment_527 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_525,asemeComment_527 skipwhite skipempty
syntax match asemeReference_525 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_511,asemeClause_514,asemeClause_516,asemePunctuation_520,asemeReference_523
syntax match asemeReference_523 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_522,@asemeSendsInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax region asemeComment_524 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_522,@asemeSendsInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax match asemeComment_524 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_522,@asemeSendsInBodyOfParticipant,asemeComment_524 skipwhite skipempty
syntax match asemeReference_522 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax match asemePunctuation_520 /\v\,/ contained nextgroup=asemeReference_518,asemeComment_521 skipwhite skipempty
syntax region asemeComment_521 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_518,asemeComment_521 skipwhite skipempty
syntax match asemeComment_521 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_518,asemeComment_521 skipwhite skipempty
syntax match asemeReference_518 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_517,asemeComment_519 skipwhite skipempty
syntax region asemeComment_519 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_517,asemeComment_519 skipwhite skipempty
syntax match asemeComment_519 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_517,asemeComment_519 skipwhite skipempty
syntax match asemeReference_517 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax match asemeClause_516 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax match asemeClause_514 /\vor%(<|>)/ contained nextgroup=asemeReference_513,asemeComment_515 skipwhite skipempty
syntax region asemeComment_515 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_513,asemeComment_515 skipwhite skipempty
syntax match asemeComment_515 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_513,asemeComment_515 skipwhite skipempty
syntax match asemeReference_513 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax match asemeClause_511 /\vby%(<|>)/ contained nextgroup=asemeReference_509,asemeComment_512 skipwhite skipempty
syntax region asemeComment_512 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_509,asemeComment_512 skipwhite skipempty
syntax match asemeComment_512 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_509,asemeComment_512 skipwhite skipempty
syntax match asemeReference_509 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax region asemeComment_510 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax match asemeComment_510 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_510 skipwhite skipempty
syntax match asemeDeclaration_507 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_505,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_505,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_505,asemeComment_508 skipwhite skipempty
syntax match asemeName_505 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_504,asemeComment_506 skipwhite skipempty
syntax region asemeComment_506 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_504,asemeComment_506 skipwhite skipempty
syntax match asemeComment_506 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_504,asemeComment_506 skipwhite skipempty
syntax match asemeOperator_504 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeDeclaration_502 /\v%(result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=result%(<|>)/ contained nextgroup=asemeName_500,asemeComment_503 skipwhite skipempty
syntax region asemeComment_503 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_500,asemeComment_503 skipwhite skipempty
syntax match asemeComment_503 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_500,asemeComment_503 skipwhite skipempty
syntax match asemeName_500 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_498,asemeComment_501 skipwhite skipempty
syntax region asemeComment_501 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_498,asemeComment_501 skipwhite skipempty
syntax match asemeComment_501 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_498,asemeComment_501 skipwhite skipempty
syntax match asemePunctuation_498 /\v\:/ contained nextgroup=asemeBuiltIn_496,asemeType_497,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_496,asemeType_497,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_496,asemeType_497,asemeComment_499 skipwhite skipempty
syntax match asemeType_497 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeBuiltIn_496 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax cluster asemeResultInBodyOfParticipant contains=asemeNumber_444,asemePunctuation_447,asemePunctuation_451,asemeOperator_487,asemeName_492,asemeBuiltIn_494,asemeType_495
syntax match asemeType_495 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeBuiltIn_494 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeName_492 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_490,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_490,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_490,asemeComment_493 skipwhite skipempty
syntax match asemePunctuation_490 /\v\:/ contained nextgroup=asemeBuiltIn_488,asemeType_489,asemeComment_491 skipwhite skipempty
syntax region asemeComment_491 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_488,asemeType_489,asemeComment_491 skipwhite skipempty
syntax match asemeComment_491 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_488,asemeType_489,asemeComment_491 skipwhite skipempty
syntax match asemeType_489 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeBuiltIn_488 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeOperator_487 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemePunctuation_451 /\v\:/ contained nextgroup=asemeBuiltIn_449,asemeType_450,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_449,asemeType_450,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_449,asemeType_450,asemeComment_452 skipwhite skipempty
syntax match asemeType_450 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeBuiltIn_449 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemePunctuation_447 /\v\.\./ contained nextgroup=asemeNumber_446,asemeComment_448 skipwhite skipempty
syntax region asemeComment_448 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_446,asemeComment_448 skipwhite skipempty
syntax match asemeComment_448 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_446,asemeComment_448 skipwhite skipempty
syntax match asemeNumber_446 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeNumber_444 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_442,asemeComment_445 skipwhite skipempty
syntax region asemeComment_445 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_442,asemeComment_445 skipwhite skipempty
syntax match asemeComment_445 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_442,asemeComment_445 skipwhite skipempty
syntax match asemePunctuation_442 /\v\.\./ contained nextgroup=asemeNumber_440,asemeComment_443 skipwhite skipempty
syntax region asemeComment_443 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_440,asemeComment_443 skipwhite skipempty
syntax match asemeComment_443 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_440,asemeComment_443 skipwhite skipempty
syntax match asemeNumber_440 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax region asemeComment_441 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeComment_441 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_441 skipwhite skipempty
syntax match asemeDeclaration_438 /\v%(given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=given%(<|>)/ contained nextgroup=asemeName_436,asemeComment_439 skipwhite skipempty
syntax region asemeComment_439 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_436,asemeComment_439 skipwhite skipempty
syntax match asemeComment_439 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_436,asemeComment_439 skipwhite skipempty
syntax match asemeName_436 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_434,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_434,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_434,asemeComment_437 skipwhite skipempty
syntax match asemePunctuation_434 /\v\:/ contained nextgroup=asemeBuiltIn_432,asemeType_433,asemeComment_435 skipwhite skipempty
syntax region asemeComment_435 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_432,asemeType_433,asemeComment_435 skipwhite skipempty
syntax match asemeComment_435 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_432,asemeType_433,asemeComment_435 skipwhite skipempty
syntax match asemeType_433 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained
syntax match asemeBuiltIn_432 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained
syntax match asemeDeclaration_430 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_429,asemeComment_431 skipwhite skipempty
syntax region asemeComment_431 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_429,asemeComment_431 skipwhite skipempty
syntax match asemeComment_431 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_429,asemeComment_431 skipwhite skipempty
syntax match asemeName_429 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemeClause_371,asemeClause_373,asemePunctuation_377,asemeNumber_382,asemePunctuation_387,asemePunctuation_390,asemePunctuation_392,asemeOperator_427,asemeName_428
syntax match asemeName_428 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeOperator_427 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemePunctuation_392 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemePunctuation_390 /\v\.\./ contained nextgroup=asemeNumber_389,asemeComment_391 skipwhite skipempty
syntax region asemeComment_391 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_389,asemeComment_391 skipwhite skipempty
syntax match asemeComment_391 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_389,asemeComment_391 skipwhite skipempty
syntax match asemeNumber_389 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemePunctuation_387 /\v\:/ contained nextgroup=asemeClause_384,asemeBuiltIn_385,asemeType_386,asemeComment_388 skipwhite skipempty
syntax region asemeComment_388 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_384,asemeBuiltIn_385,asemeType_386,asemeComment_388 skipwhite skipempty
syntax match asemeComment_388 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_384,asemeBuiltIn_385,asemeType_386,asemeComment_388 skipwhite skipempty
syntax match asemeType_386 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeBuiltIn_385 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeClause_384 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeNumber_382 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_380,asemeComment_383 skipwhite skipempty
syntax region asemeComment_383 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_380,asemeComment_383 skipwhite skipempty
syntax match asemeComment_383 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_380,asemeComment_383 skipwhite skipempty
syntax match asemePunctuation_380 /\v\.\./ contained nextgroup=asemeNumber_379,asemeComment_381 skipwhite skipempty
syntax region asemeComment_381 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_379,asemeComment_381 skipwhite skipempty
syntax match asemeComment_381 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_379,asemeComment_381 skipwhite skipempty
syntax match asemeNumber_379 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemePunctuation_377 /\v\[/ contained nextgroup=asemeNumber_375,asemeComment_378 skipwhite skipempty
syntax region asemeComment_378 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_375,asemeComment_378 skipwhite skipempty
syntax match asemeComment_378 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_375,asemeComment_378 skipwhite skipempty
syntax match asemeNumber_375 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_374,asemeComment_376 skipwhite skipempty
syntax region asemeComment_376 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_374,asemeComment_376 skipwhite skipempty
syntax match asemeComment_376 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_374,asemeComment_376 skipwhite skipempty
syntax match asemePunctuation_374 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeClause_373 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeClause_371 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_368,asemeType_370,asemeComment_372 skipwhite skipempty
syntax region asemeComment_372 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_368,asemeType_370,asemeComment_372 skipwhite skipempty
syntax match asemeComment_372 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_368,asemeType_370,asemeComment_372 skipwhite skipempty
syntax match asemeType_370 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeBuiltIn_368 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax region asemeComment_369 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeComment_369 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_369 skipwhite skipempty
syntax match asemeDeclaration_366 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_364,asemeComment_367 skipwhite skipempty
syntax region asemeComment_367 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_364,asemeComment_367 skipwhite skipempty
syntax match asemeComment_367 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_364,asemeComment_367 skipwhite skipempty
syntax match asemeReference_364 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_362,asemeComment_365 skipwhite skipempty
syntax region asemeComment_365 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_362,asemeComment_365 skipwhite skipempty
syntax match asemeComment_365 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_362,asemeComment_365 skipwhite skipempty
syntax match asemePunctuation_362 /\v\./ contained nextgroup=asemeReference_361,asemeComment_363 skipwhite skipempty
syntax region asemeComment_363 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_361,asemeComment_363 skipwhite skipempty
syntax match asemeComment_363 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_361,asemeComment_363 skipwhite skipempty
syntax match asemeReference_361 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax cluster asemePlaysInBodyOfParticipant contains=asemeClause_303,asemeClause_307,asemeClause_338,asemeClause_340,asemePunctuation_349,asemePunctuation_352,asemeOperator_354,asemeReference_358,asemeReference_360
syntax match asemeReference_360 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeReference_358 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_356,asemeComment_359 skipwhite skipempty
syntax region asemeComment_359 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_356,asemeComment_359 skipwhite skipempty
syntax match asemeComment_359 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_356,asemeComment_359 skipwhite skipempty
syntax match asemePunctuation_356 /\v\./ contained nextgroup=asemeReference_355,asemeComment_357 skipwhite skipempty
syntax region asemeComment_357 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_355,asemeComment_357 skipwhite skipempty
syntax match asemeComment_357 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_355,asemeComment_357 skipwhite skipempty
syntax match asemeReference_355 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeOperator_354 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemePunctuation_352 /\v\./ contained nextgroup=asemeReference_351,asemeComment_353 skipwhite skipempty
syntax region asemeComment_353 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_351,asemeComment_353 skipwhite skipempty
syntax match asemeComment_353 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_351,asemeComment_353 skipwhite skipempty
syntax match asemeReference_351 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemePunctuation_349 /\v\,/ contained nextgroup=asemeReference_344,asemeReference_347,asemeComment_350 skipwhite skipempty
syntax region asemeComment_350 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_344,asemeReference_347,asemeComment_350 skipwhite skipempty
syntax match asemeComment_350 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_344,asemeReference_347,asemeComment_350 skipwhite skipempty
syntax match asemeReference_347 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_346,asemeComment_348 skipwhite skipempty
syntax region asemeComment_348 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_346,asemeComment_348 skipwhite skipempty
syntax match asemeComment_348 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_346,asemeComment_348 skipwhite skipempty
syntax match asemeOperator_346 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeReference_344 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_342,asemeComment_345 skipwhite skipempty
syntax region asemeComment_345 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_342,asemeComment_345 skipwhite skipempty
syntax match asemeComment_345 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_342,asemeComment_345 skipwhite skipempty
syntax match asemePunctuation_342 /\v\./ contained nextgroup=asemeReference_341,asemeComment_343 skipwhite skipempty
syntax region asemeComment_343 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_341,asemeComment_343 skipwhite skipempty
syntax match asemeComment_343 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_341,asemeComment_343 skipwhite skipempty
syntax match asemeReference_341 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeClause_340 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_338 /\vwhen%(<|>)/ contained nextgroup=asemeClause_337,asemeComment_339 skipwhite skipempty
syntax region asemeComment_339 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_337,asemeComment_339 skipwhite skipempty
syntax match asemeComment_339 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_337,asemeComment_339 skipwhite skipempty
syntax match asemeClause_337 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_307 /\vas%(<|>)/ contained nextgroup=asemeReference_305,asemeComment_308 skipwhite skipempty
syntax region asemeComment_308 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_305,asemeComment_308 skipwhite skipempty
syntax match asemeComment_308 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_305,asemeComment_308 skipwhite skipempty
syntax match asemeReference_305 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax region asemeComment_306 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeComment_306 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_306 skipwhite skipempty
syntax match asemeClause_303 /\vwith%(<|>)/ contained nextgroup=asemeReference_301,asemeComment_304 skipwhite skipempty
syntax region asemeComment_304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_301,asemeComment_304 skipwhite skipempty
syntax match asemeComment_304 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_301,asemeComment_304 skipwhite skipempty
syntax match asemeReference_301 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_300,asemeComment_302 skipwhite skipempty
syntax region asemeComment_302 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_300,asemeComment_302 skipwhite skipempty
syntax match asemeComment_302 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_300,asemeComment_302 skipwhite skipempty
syntax match asemeOperator_300 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeDeclaration_264 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_263,asemeComment_265 skipwhite skipempty
syntax region asemeComment_265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_263,asemeComment_265 skipwhite skipempty
syntax match asemeComment_265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_263,asemeComment_265 skipwhite skipempty
syntax match asemeText_263 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_262 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax match asemePunctuation_260 /\v\.\./ contained nextgroup=asemeNumber_259,asemeComment_261 skipwhite skipempty
syntax region asemeComment_261 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_259,asemeComment_261 skipwhite skipempty
syntax match asemeComment_261 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_259,asemeComment_261 skipwhite skipempty
syntax match asemeNumber_259 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax match asemePunctuation_257 /\v\[/ contained nextgroup=asemeNumber_255,asemeComment_258 skipwhite skipempty
syntax region asemeComment_258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_255,asemeComment_258 skipwhite skipempty
syntax match asemeComment_258 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_255,asemeComment_258 skipwhite skipempty
syntax match asemeNumber_255 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax region asemeComment_256 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax match asemeComment_256 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_256 skipwhite skipempty
syntax match asemeDeclaration_253 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_254 skipwhite skipempty
syntax region asemeComment_254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_254 skipwhite skipempty
syntax match asemeComment_254 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_254 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_252
syntax region asemePunctuation_252 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_232,asemeDeclaration_250,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_250 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_249,asemeComment_251 skipwhite skipempty
syntax region asemeComment_251 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_249,asemeComment_251 skipwhite skipempty
syntax match asemeComment_251 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_249,asemeComment_251 skipwhite skipempty
syntax match asemeName_249 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_236,asemeClause_239,asemeClause_242,asemePunctuation_245,asemeText_247,asemeName_248
syntax match asemeName_248 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemeText_247 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemePunctuation_245 /\v\,/ contained nextgroup=asemeReference_244,asemeComment_246 skipwhite skipempty
syntax region asemeComment_246 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_244,asemeComment_246 skipwhite skipempty
syntax match asemeComment_246 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_244,asemeComment_246 skipwhite skipempty
syntax match asemeReference_244 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemeClause_242 /\vrealises%(<|>)/ contained nextgroup=asemeReference_241,asemeComment_243 skipwhite skipempty
syntax region asemeComment_243 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_241,asemeComment_243 skipwhite skipempty
syntax match asemeComment_243 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_241,asemeComment_243 skipwhite skipempty
syntax match asemeReference_241 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemeClause_239 /\vincludes%(<|>)/ contained nextgroup=asemeReference_238,asemeComment_240 skipwhite skipempty
syntax region asemeComment_240 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_238,asemeComment_240 skipwhite skipempty
syntax match asemeComment_240 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_238,asemeComment_240 skipwhite skipempty
syntax match asemeReference_238 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemeClause_236 /\vby%(<|>)/ contained nextgroup=asemeReference_234,asemeComment_237 skipwhite skipempty
syntax region asemeComment_237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_234,asemeComment_237 skipwhite skipempty
syntax match asemeComment_237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_234,asemeComment_237 skipwhite skipempty
syntax match asemeReference_234 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax region asemeComment_235 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemeComment_235 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_235 skipwhite skipempty
syntax match asemeDeclaration_232 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_231,asemeComment_233 skipwhite skipempty
syntax region asemeComment_233 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_231,asemeComment_233 skipwhite skipempty
syntax match asemeComment_233 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_231,asemeComment_233 skipwhite skipempty
syntax match asemeReference_231 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemeChoice_222,asemePunctuation_225,asemePunctuation_228,asemeReference_230
syntax match asemeReference_230 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax match asemePunctuation_228 /\v\:/ contained nextgroup=asemeChoice_227,asemeComment_229 skipwhite skipempty
syntax region asemeComment_229 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_227,asemeComment_229 skipwhite skipempty
syntax match asemeComment_229 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_227,asemeComment_229 skipwhite skipempty
syntax match asemeChoice_227 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax match asemePunctuation_225 /\v\,/ contained nextgroup=asemeReference_224,asemeComment_226 skipwhite skipempty
syntax region asemeComment_226 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_224,asemeComment_226 skipwhite skipempty
syntax match asemeComment_226 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_224,asemeComment_226 skipwhite skipempty
syntax match asemeReference_224 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax match asemeChoice_222 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax region asemeComment_223 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax match asemeComment_223 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_223 skipwhite skipempty
syntax match asemeDeclaration_220 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_221 skipwhite skipempty
syntax region asemeComment_221 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_221 skipwhite skipempty
syntax match asemeComment_221 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_221 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_219
syntax region asemePunctuation_219 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_217,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_217 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_216,asemeComment_218 skipwhite skipempty
syntax region asemeComment_218 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_216,asemeComment_218 skipwhite skipempty
syntax match asemeComment_218 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_216,asemeComment_218 skipwhite skipempty
syntax match asemeBlock_216 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_215 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_213,asemeBlock_214
syntax match asemeBlock_214 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_215 skipwhite skipempty
syntax region asemeComment_215 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_215 skipwhite skipempty
syntax match asemeComment_215 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_215 skipwhite skipempty
syntax region asemePunctuation_213 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_211,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_211 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_210,asemeComment_212 skipwhite skipempty
syntax region asemeComment_212 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_210,asemeComment_212 skipwhite skipempty
syntax match asemeComment_212 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_210,asemeComment_212 skipwhite skipempty
syntax match asemeName_210 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_200,asemeClause_203,asemePunctuation_206,asemeText_208,asemeName_209
syntax match asemeName_209 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax match asemeText_208 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax match asemePunctuation_206 /\v\,/ contained nextgroup=asemeReference_205,asemeComment_207 skipwhite skipempty
syntax region asemeComment_207 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_205,asemeComment_207 skipwhite skipempty
syntax match asemeComment_207 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_205,asemeComment_207 skipwhite skipempty
syntax match asemeReference_205 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax match asemeClause_203 /\von%(<|>)/ contained nextgroup=asemeReference_202,asemeComment_204 skipwhite skipempty
syntax region asemeComment_204 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_202,asemeComment_204 skipwhite skipempty
syntax match asemeComment_204 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_202,asemeComment_204 skipwhite skipempty
syntax match asemeReference_202 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax match asemeClause_200 /\vdepends%(<|>)/ contained nextgroup=asemeClause_198,asemeComment_201 skipwhite skipempty
syntax region asemeComment_201 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_198,asemeComment_201 skipwhite skipempty
syntax match asemeComment_201 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_198,asemeComment_201 skipwhite skipempty
syntax match asemeClause_198 /\von%(<|>)/ contained nextgroup=asemeReference_196,asemeComment_199 skipwhite skipempty
syntax region asemeComment_199 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_196,asemeComment_199 skipwhite skipempty
syntax match asemeComment_199 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_196,asemeComment_199 skipwhite skipempty
syntax match asemeReference_196 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax region asemeComment_197 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax match asemeComment_197 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_197 skipwhite skipempty
syntax match asemeDeclaration_194 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_192,asemeComment_195 skipwhite skipempty
syntax region asemeComment_195 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_192,asemeComment_195 skipwhite skipempty
syntax match asemeComment_195 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_192,asemeComment_195 skipwhite skipempty
syntax match asemeName_192 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_191,asemeComment_193 skipwhite skipempty
syntax region asemeComment_193 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_191,asemeComment_193 skipwhite skipempty
syntax match asemeComment_193 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_191,asemeComment_193 skipwhite skipempty
syntax match asemePunctuation_191 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_164,asemePunctuation_172,asemePunctuation_178,asemeOperator_181,asemePunctuation_183,asemeBuiltIn_185,asemeType_187,asemeName_189
syntax match asemeName_189 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_188,asemeComment_190 skipwhite skipempty
syntax region asemeComment_190 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_188,asemeComment_190 skipwhite skipempty
syntax match asemeComment_190 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_188,asemeComment_190 skipwhite skipempty
syntax match asemePunctuation_188 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemeType_187 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_184,asemeComment_186 skipwhite skipempty
syntax match asemeBuiltIn_185 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_184,asemeComment_186 skipwhite skipempty
syntax region asemeComment_186 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_184,asemeComment_186 skipwhite skipempty
syntax match asemeComment_186 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_184,asemeComment_186 skipwhite skipempty
syntax match asemeName_184 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemePunctuation_183 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemeOperator_181 /\v\=%(\=)@!/ contained nextgroup=asemeText_180,asemeComment_182 skipwhite skipempty
syntax region asemeComment_182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_180,asemeComment_182 skipwhite skipempty
syntax match asemeComment_182 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_180,asemeComment_182 skipwhite skipempty
syntax match asemeText_180 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemePunctuation_178 /\v\,/ contained nextgroup=asemeBuiltIn_175,asemeType_177,asemeComment_179 skipwhite skipempty
syntax region asemeComment_179 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_175,asemeType_177,asemeComment_179 skipwhite skipempty
syntax match asemeComment_179 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_175,asemeType_177,asemeComment_179 skipwhite skipempty
syntax match asemeType_177 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax match asemeBuiltIn_175 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax region asemeComment_176 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax match asemeComment_176 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_174,asemeComment_176 skipwhite skipempty
syntax match asemeName_174 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemePunctuation_172 /\v\:/ contained nextgroup=asemeBuiltIn_169,asemeType_171,asemeComment_173 skipwhite skipempty
syntax region asemeComment_173 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_169,asemeType_171,asemeComment_173 skipwhite skipempty
syntax match asemeComment_173 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_169,asemeType_171,asemeComment_173 skipwhite skipempty
syntax match asemeType_171 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_167,asemeComment_170 skipwhite skipempty
syntax match asemeBuiltIn_169 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_167,asemeComment_170 skipwhite skipempty
syntax region asemeComment_170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_167,asemeComment_170 skipwhite skipempty
syntax match asemeComment_170 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_167,asemeComment_170 skipwhite skipempty
syntax match asemeOperator_167 /\v\=%(\=)@!/ contained nextgroup=asemeText_166,asemeComment_168 skipwhite skipempty
syntax region asemeComment_168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_166,asemeComment_168 skipwhite skipempty
syntax match asemeComment_168 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_166,asemeComment_168 skipwhite skipempty
syntax match asemeText_166 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemePunctuation_164 /\v\)/ contained nextgroup=asemePunctuation_162,asemeComment_165 skipwhite skipempty
syntax region asemeComment_165 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_162,asemeComment_165 skipwhite skipempty
syntax match asemeComment_165 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_162,asemeComment_165 skipwhite skipempty
syntax match asemePunctuation_162 /\v\:/ contained nextgroup=asemeBuiltIn_159,asemeType_161,asemeComment_163 skipwhite skipempty
syntax region asemeComment_163 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_159,asemeType_161,asemeComment_163 skipwhite skipempty
syntax match asemeComment_163 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_159,asemeType_161,asemeComment_163 skipwhite skipempty
syntax match asemeType_161 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_157,asemeComment_160 skipwhite skipempty
syntax match asemeBuiltIn_159 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_157,asemeComment_160 skipwhite skipempty
syntax region asemeComment_160 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_157,asemeComment_160 skipwhite skipempty
syntax match asemeComment_160 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_157,asemeComment_160 skipwhite skipempty
syntax match asemeOperator_157 /\v\=%(\=)@!/ contained nextgroup=asemeText_155,asemeComment_158 skipwhite skipempty
syntax region asemeComment_158 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_155,asemeComment_158 skipwhite skipempty
syntax match asemeComment_158 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_155,asemeComment_158 skipwhite skipempty
syntax match asemeText_155 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax region asemeComment_156 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemeComment_156 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_156 skipwhite skipempty
syntax match asemeDeclaration_153 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_152,asemeComment_154 skipwhite skipempty
syntax region asemeComment_154 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_152,asemeComment_154 skipwhite skipempty
syntax match asemeComment_154 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_152,asemeComment_154 skipwhite skipempty
syntax match asemeBlock_152 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_123,asemeClause_126,asemeClause_129,asemePunctuation_150,asemeBlock_151
syntax match asemeBlock_151 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax region asemePunctuation_150 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_148,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_148 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_147,asemeComment_149 skipwhite skipempty
syntax region asemeComment_149 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_147,asemeComment_149 skipwhite skipempty
syntax match asemeComment_149 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_147,asemeComment_149 skipwhite skipempty
syntax match asemeReference_147 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_133,asemeClause_136,asemeClause_139,asemeChoice_141,asemePunctuation_144,asemeReference_146
syntax match asemeReference_146 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemePunctuation_144 /\v\,/ contained nextgroup=asemeReference_142,asemeReference_143,asemeComment_145 skipwhite skipempty
syntax region asemeComment_145 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_142,asemeReference_143,asemeComment_145 skipwhite skipempty
syntax match asemeComment_145 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_142,asemeReference_143,asemeComment_145 skipwhite skipempty
syntax match asemeReference_143 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeReference_142 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeChoice_141 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeClause_139 /\vexpires%(<|>)/ contained nextgroup=asemeNumber_138,asemeComment_140 skipwhite skipempty
syntax region asemeComment_140 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_138,asemeComment_140 skipwhite skipempty
syntax match asemeComment_140 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_138,asemeComment_140 skipwhite skipempty
syntax match asemeNumber_138 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeClause_136 /\vevery%(<|>)/ contained nextgroup=asemeNumber_135,asemeComment_137 skipwhite skipempty
syntax region asemeComment_137 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_135,asemeComment_137 skipwhite skipempty
syntax match asemeComment_137 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_135,asemeComment_137 skipwhite skipempty
syntax match asemeNumber_135 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeClause_133 /\vfrom%(<|>)/ contained nextgroup=asemeReference_131,asemeComment_134 skipwhite skipempty
syntax region asemeComment_134 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_131,asemeComment_134 skipwhite skipempty
syntax match asemeComment_134 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_131,asemeComment_134 skipwhite skipempty
syntax match asemeReference_131 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax region asemeComment_132 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeComment_132 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_132 skipwhite skipempty
syntax match asemeClause_129 /\vdelay%(<|>)/ contained nextgroup=asemeNumber_128,asemeComment_130 skipwhite skipempty
syntax region asemeComment_130 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_128,asemeComment_130 skipwhite skipempty
syntax match asemeComment_130 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_128,asemeComment_130 skipwhite skipempty
syntax match asemeNumber_128 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax match asemeClause_126 /\vradio%(<|>)/ contained nextgroup=asemeNumber_125,asemeComment_127 skipwhite skipempty
syntax region asemeComment_127 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_125,asemeComment_127 skipwhite skipempty
syntax match asemeComment_127 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_125,asemeComment_127 skipwhite skipempty
syntax match asemeNumber_125 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax match asemeClause_123 /\vunder%(<|>)/ contained nextgroup=asemeReference_121,asemeComment_124 skipwhite skipempty
syntax region asemeComment_124 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_121,asemeComment_124 skipwhite skipempty
syntax match asemeComment_124 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_121,asemeComment_124 skipwhite skipempty
syntax match asemeReference_121 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax region asemeComment_122 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax match asemeComment_122 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_122 skipwhite skipempty
syntax match asemeDeclaration_119 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_118,asemeComment_120 skipwhite skipempty
syntax region asemeComment_120 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_118,asemeComment_120 skipwhite skipempty
syntax match asemeComment_120 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_118,asemeComment_120 skipwhite skipempty
syntax match asemeBlock_118 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_117 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_115,asemeBlock_116
syntax match asemeBlock_116 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_117 skipwhite skipempty
syntax region asemeComment_117 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_117 skipwhite skipempty
syntax match asemeComment_117 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_117 skipwhite skipempty
syntax region asemePunctuation_115 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_109,asemeBuiltIn_112,asemeType_114,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeType_114 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_111,asemeComment_113 skipwhite skipempty
syntax match asemeBuiltIn_112 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_111,asemeComment_113 skipwhite skipempty
syntax region asemeComment_113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_111,asemeComment_113 skipwhite skipempty
syntax match asemeComment_113 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_111,asemeComment_113 skipwhite skipempty
syntax match asemeName_111 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax match asemeDeclaration_109 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_106,asemeType_108,asemeComment_110 skipwhite skipempty
syntax region asemeComment_110 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_106,asemeType_108,asemeComment_110 skipwhite skipempty
syntax match asemeComment_110 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_106,asemeType_108,asemeComment_110 skipwhite skipempty
syntax match asemeType_108 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax match asemeBuiltIn_106 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax region asemeComment_107 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax match asemeComment_107 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_105,asemeComment_107 skipwhite skipempty
syntax match asemeName_105 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_97,asemePunctuation_99,asemeBuiltIn_101,asemeType_103,asemeName_104
syntax match asemeName_104 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax match asemeType_103 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax match asemeBuiltIn_101 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax region asemeComment_102 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax match asemeComment_102 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_100,asemeComment_102 skipwhite skipempty
syntax match asemeName_100 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax match asemePunctuation_99 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax match asemeOperator_97 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_95,asemeComment_98 skipwhite skipempty
syntax region asemeComment_98 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_95,asemeComment_98 skipwhite skipempty
syntax match asemeComment_98 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_95,asemeComment_98 skipwhite skipempty
syntax match asemeNumber_95 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax region asemeComment_96 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax match asemeComment_96 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_96 skipwhite skipempty
syntax match asemeDeclaration_93 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_92,asemeComment_94 skipwhite skipempty
syntax region asemeComment_94 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_92,asemeComment_94 skipwhite skipempty
syntax match asemeComment_94 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_92,asemeComment_94 skipwhite skipempty
syntax match asemeBlock_92 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_91 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_89,asemeBlock_90
syntax match asemeBlock_90 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_91 skipwhite skipempty
syntax region asemeComment_91 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_91 skipwhite skipempty
syntax match asemeComment_91 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_91 skipwhite skipempty
syntax region asemePunctuation_89 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_88,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_88 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_84 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_85,asemePunctuation_87
syntax match asemePunctuation_87 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_84 skipwhite skipempty
syntax match asemeOperator_85 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_83,asemeComment_86 skipwhite skipempty
syntax region asemeComment_86 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_83,asemeComment_86 skipwhite skipempty
syntax match asemeComment_86 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_83,asemeComment_86 skipwhite skipempty
syntax match asemeNumber_83 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_84 skipwhite skipempty
syntax region asemeComment_84 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_84 skipwhite skipempty
syntax match asemeComment_84 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_84 skipwhite skipempty
syntax match asemeDeclaration_81 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_79,asemeComment_82 skipwhite skipempty
syntax region asemeComment_82 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_79,asemeComment_82 skipwhite skipempty
syntax match asemeComment_82 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_79,asemeComment_82 skipwhite skipempty
syntax match asemeName_79 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_78,asemeComment_80 skipwhite skipempty
syntax region asemeComment_80 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_78,asemeComment_80 skipwhite skipempty
syntax match asemeComment_80 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_78,asemeComment_80 skipwhite skipempty
syntax match asemeOperator_78 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_1264,asemeClause_1267,asemeReference_1269,asemeText_1270,asemeNumber_1271,asemeTruth_1272,asemeLogic_1273,asemeClause_1274,asemeClause_1275,asemeClause_1276,asemeClause_1277,asemeClause_1278,asemeClause_1279,asemeClause_1280,asemeClause_1281,asemeClause_1282,asemeClause_1283,asemeClause_1284,asemeClause_1285,asemeClause_1286,asemeClause_1287,asemeCall_1288,asemeReference_1289,asemeOperator_1290,asemePunctuation_1291
syntax match asemePunctuation_1291 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeOperator_1290 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeReference_1289 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeCall_1288 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1287 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1286 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1285 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1284 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1283 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1282 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1281 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1280 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1279 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1278 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1277 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1276 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1275 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeClause_1274 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeLogic_1273 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeTruth_1272 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeNumber_1271 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeText_1270 /\v%(%(%(%(%(true|false|index)\_s*\:)@![A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeReference_1269 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1259,asemeComment_1261 skipwhite skipempty
syntax match asemeClause_1267 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1266,asemeComment_1268 skipwhite skipempty
syntax region asemeComment_1268 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1266,asemeComment_1268 skipwhite skipempty
syntax match asemeComment_1268 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1266,asemeComment_1268 skipwhite skipempty
syntax match asemeReference_1266 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1259,asemeComment_1261 skipwhite skipempty
syntax match asemeClause_1264 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1262,asemeComment_1265 skipwhite skipempty
syntax region asemeComment_1265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1262,asemeComment_1265 skipwhite skipempty
syntax match asemeComment_1265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1262,asemeComment_1265 skipwhite skipempty
syntax match asemeReference_1262 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1260,asemeComment_1263 skipwhite skipempty
syntax region asemeComment_1263 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1260,asemeComment_1263 skipwhite skipempty
syntax match asemeComment_1263 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1260,asemeComment_1263 skipwhite skipempty
syntax match asemeReference_1260 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1259,asemeComment_1261 skipwhite skipempty
syntax region asemeComment_1261 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1259,asemeComment_1261 skipwhite skipempty
syntax match asemeComment_1261 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1259,asemeComment_1261 skipwhite skipempty
syntax region asemePunctuation_1259 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax region asemeComment_1258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax match asemeComment_1258 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1258 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_1210,asemeClause_1213,asemeReference_1215,asemeText_1216,asemeNumber_1217,asemeTruth_1218,asemeLogic_1219,asemeClause_1220,asemeClause_1221,asemeClause_1222,asemeClause_1223,asemeClause_1224,asemeClause_1225,asemeClause_1226,asemeClause_1227,asemeClause_1228,asemeClause_1229,asemeClause_1230,asemeClause_1231,asemeClause_1232,asemeClause_1233,asemeCall_1234,asemeReference_1235,asemeOperator_1236,asemePunctuation_1237
syntax match asemePunctuation_1237 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeOperator_1236 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeReference_1235 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeCall_1234 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1233 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1232 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1231 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1230 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1229 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1228 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1227 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1226 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1225 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1224 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1223 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1222 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1221 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeClause_1220 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeLogic_1219 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeTruth_1218 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeNumber_1217 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeText_1216 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeReference_1215 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1205,asemeComment_1207 skipwhite skipempty
syntax match asemeClause_1213 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1212,asemeComment_1214 skipwhite skipempty
syntax region asemeComment_1214 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1212,asemeComment_1214 skipwhite skipempty
syntax match asemeComment_1214 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1212,asemeComment_1214 skipwhite skipempty
syntax match asemeReference_1212 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1205,asemeComment_1207 skipwhite skipempty
syntax match asemeClause_1210 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1208,asemeComment_1211 skipwhite skipempty
syntax region asemeComment_1211 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1208,asemeComment_1211 skipwhite skipempty
syntax match asemeComment_1211 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1208,asemeComment_1211 skipwhite skipempty
syntax match asemeReference_1208 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1206,asemeComment_1209 skipwhite skipempty
syntax region asemeComment_1209 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1206,asemeComment_1209 skipwhite skipempty
syntax match asemeComment_1209 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1206,asemeComment_1209 skipwhite skipempty
syntax match asemeReference_1206 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1205,asemeComment_1207 skipwhite skipempty
syntax region asemeComment_1207 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1205,asemeComment_1207 skipwhite skipempty
syntax match asemeComment_1207 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1205,asemeComment_1207 skipwhite skipempty
syntax region asemePunctuation_1205 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax region asemeComment_1204 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax match asemeComment_1204 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1204 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_1146,asemeClause_1149,asemeReference_1151,asemeText_1152,asemeNumber_1153,asemeTruth_1154,asemeLogic_1155,asemeClause_1156,asemeClause_1157,asemeClause_1158,asemeClause_1159,asemeClause_1160,asemeClause_1161,asemeClause_1162,asemeClause_1163,asemeClause_1164,asemeClause_1165,asemeClause_1166,asemeClause_1167,asemeClause_1168,asemeClause_1169,asemeCall_1170,asemeReference_1171,asemeOperator_1172,asemePunctuation_1173
syntax match asemePunctuation_1173 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeOperator_1172 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeReference_1171 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeCall_1170 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1169 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1168 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1167 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1166 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1165 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1164 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1163 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1162 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1161 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1160 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1159 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1158 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1157 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeClause_1156 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeLogic_1155 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeTruth_1154 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeNumber_1153 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeText_1152 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeReference_1151 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1141,asemeComment_1143 skipwhite skipempty
syntax match asemeClause_1149 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1148,asemeComment_1150 skipwhite skipempty
syntax region asemeComment_1150 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1148,asemeComment_1150 skipwhite skipempty
syntax match asemeComment_1150 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1148,asemeComment_1150 skipwhite skipempty
syntax match asemeReference_1148 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1141,asemeComment_1143 skipwhite skipempty
syntax match asemeClause_1146 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1144,asemeComment_1147 skipwhite skipempty
syntax region asemeComment_1147 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1144,asemeComment_1147 skipwhite skipempty
syntax match asemeComment_1147 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1144,asemeComment_1147 skipwhite skipempty
syntax match asemeReference_1144 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1142,asemeComment_1145 skipwhite skipempty
syntax region asemeComment_1145 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1142,asemeComment_1145 skipwhite skipempty
syntax match asemeComment_1145 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1142,asemeComment_1145 skipwhite skipempty
syntax match asemeReference_1142 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1141,asemeComment_1143 skipwhite skipempty
syntax region asemeComment_1143 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1141,asemeComment_1143 skipwhite skipempty
syntax match asemeComment_1143 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1141,asemeComment_1143 skipwhite skipempty
syntax region asemePunctuation_1141 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax region asemeComment_1140 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax match asemeComment_1140 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1140 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_937,asemeNumber_939,asemeReference_940,asemeNumber_941,asemeOperator_942,asemePunctuation_943
syntax match asemePunctuation_943 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemeOperator_942 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemeNumber_941 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemeReference_940 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemeNumber_939 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemeText_937 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax region asemeComment_938 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax match asemeComment_938 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_938 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_887,asemeClause_890,asemeReference_892,asemeText_893,asemeNumber_894,asemeTruth_895,asemeLogic_896,asemeClause_897,asemeClause_898,asemeClause_899,asemeClause_900,asemeClause_901,asemeClause_902,asemeClause_903,asemeClause_904,asemeClause_905,asemeClause_906,asemeClause_907,asemeClause_908,asemeClause_909,asemeClause_910,asemeCall_911,asemeReference_912,asemeOperator_913,asemePunctuation_914
syntax match asemePunctuation_914 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeOperator_913 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeReference_912 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeCall_911 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_910 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_909 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_908 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_907 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_906 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_905 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_904 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_903 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_902 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_901 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_900 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_899 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_898 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeClause_897 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeLogic_896 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeTruth_895 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeNumber_894 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeText_893 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeReference_892 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_882,asemeComment_884 skipwhite skipempty
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
syntax region asemePunctuation_882 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax region asemeComment_881 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax match asemeComment_881 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_881 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfSrm contains=asemeReference_785,asemeText_787,asemeNumber_788,asemeTruth_789,asemeLogic_790,asemeClause_791,asemeClause_792,asemeClause_793,asemeClause_794,asemeClause_795,asemeClause_796,asemeClause_797,asemeClause_798,asemeClause_799,asemeClause_800,asemeClause_801,asemeClause_802,asemeClause_803,asemeClause_804,asemeCall_805,asemeReference_806,asemeOperator_807,asemePunctuation_808
syntax match asemePunctuation_808 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeOperator_807 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeReference_806 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeCall_805 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_804 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_803 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_802 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_801 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_800 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_799 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_798 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_797 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_796 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_795 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_794 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_793 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_792 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeClause_791 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeLogic_790 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeTruth_789 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeNumber_788 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeText_787 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeReference_785 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_783,asemeComment_786 skipwhite skipempty
syntax region asemeComment_786 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_783,asemeComment_786 skipwhite skipempty
syntax match asemeComment_786 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_783,asemeComment_786 skipwhite skipempty
syntax match asemeReference_783 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax region asemeComment_784 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax match asemeComment_784 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_782,asemeComment_784 skipwhite skipempty
syntax region asemePunctuation_782 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax region asemeComment_781 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax match asemeComment_781 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_781 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfSrm contains=asemeClause_744,asemeClause_747,asemeReference_749,asemeText_750,asemeNumber_751,asemeTruth_752,asemeLogic_753,asemeClause_754,asemeClause_755,asemeClause_756,asemeClause_757,asemeClause_758,asemeClause_759,asemeClause_760,asemeClause_761,asemeClause_762,asemeClause_763,asemeClause_764,asemeClause_765,asemeClause_766,asemeClause_767,asemeCall_768,asemeReference_769,asemeOperator_770,asemePunctuation_771
syntax match asemePunctuation_771 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeOperator_770 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeReference_769 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeCall_768 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_767 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_766 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_765 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_764 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_763 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_762 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_761 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_760 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_759 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_758 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_757 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_756 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_755 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeClause_754 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeLogic_753 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeTruth_752 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeNumber_751 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeText_750 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeReference_749 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_739,asemeComment_741 skipwhite skipempty
syntax match asemeClause_747 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_746,asemeComment_748 skipwhite skipempty
syntax region asemeComment_748 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_746,asemeComment_748 skipwhite skipempty
syntax match asemeComment_748 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_746,asemeComment_748 skipwhite skipempty
syntax match asemeReference_746 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_739,asemeComment_741 skipwhite skipempty
syntax match asemeClause_744 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_742,asemeComment_745 skipwhite skipempty
syntax region asemeComment_745 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_742,asemeComment_745 skipwhite skipempty
syntax match asemeComment_745 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_742,asemeComment_745 skipwhite skipempty
syntax match asemeReference_742 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_740,asemeComment_743 skipwhite skipempty
syntax region asemeComment_743 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_740,asemeComment_743 skipwhite skipempty
syntax match asemeComment_743 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_740,asemeComment_743 skipwhite skipempty
syntax match asemeReference_740 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_739,asemeComment_741 skipwhite skipempty
syntax region asemeComment_741 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_739,asemeComment_741 skipwhite skipempty
syntax match asemeComment_741 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_739,asemeComment_741 skipwhite skipempty
syntax region asemePunctuation_739 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax region asemeComment_738 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeComment_738 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_669,asemeClause_672,asemeReference_674,asemeText_675,asemeNumber_676,asemeTruth_677,asemeLogic_678,asemeClause_679,asemeClause_680,asemeClause_681,asemeClause_682,asemeClause_683,asemeClause_684,asemeClause_685,asemeClause_686,asemeClause_687,asemeClause_688,asemeClause_689,asemeClause_690,asemeClause_691,asemeClause_692,asemeCall_693,asemeReference_694,asemeOperator_695,asemePunctuation_696
syntax match asemePunctuation_696 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeOperator_695 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeReference_694 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeCall_693 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_692 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_691 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_690 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_689 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_688 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_687 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_686 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_685 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_684 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_683 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_682 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_681 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_680 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeClause_679 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeLogic_678 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeTruth_677 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeNumber_676 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeText_675 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeReference_674 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_664,asemeComment_666 skipwhite skipempty
syntax match asemeClause_672 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_671,asemeComment_673 skipwhite skipempty
syntax region asemeComment_673 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_671,asemeComment_673 skipwhite skipempty
syntax match asemeComment_673 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_671,asemeComment_673 skipwhite skipempty
syntax match asemeReference_671 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_664,asemeComment_666 skipwhite skipempty
syntax match asemeClause_669 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_667,asemeComment_670 skipwhite skipempty
syntax region asemeComment_670 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_667,asemeComment_670 skipwhite skipempty
syntax match asemeComment_670 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_667,asemeComment_670 skipwhite skipempty
syntax match asemeReference_667 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_665,asemeComment_668 skipwhite skipempty
syntax region asemeComment_668 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_665,asemeComment_668 skipwhite skipempty
syntax match asemeComment_668 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_665,asemeComment_668 skipwhite skipempty
syntax match asemeReference_665 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_664,asemeComment_666 skipwhite skipempty
syntax region asemeComment_666 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_664,asemeComment_666 skipwhite skipempty
syntax match asemeComment_666 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_664,asemeComment_666 skipwhite skipempty
syntax region asemePunctuation_664 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax region asemeComment_663 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax match asemeComment_663 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_663 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_627,asemeClause_630,asemeReference_632,asemeText_633,asemeNumber_634,asemeTruth_635,asemeLogic_636,asemeClause_637,asemeClause_638,asemeClause_639,asemeClause_640,asemeClause_641,asemeClause_642,asemeClause_643,asemeClause_644,asemeClause_645,asemeClause_646,asemeClause_647,asemeClause_648,asemeClause_649,asemeClause_650,asemeCall_651,asemeReference_652,asemeOperator_653,asemePunctuation_654
syntax match asemePunctuation_654 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeOperator_653 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeReference_652 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeCall_651 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_650 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_649 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_648 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_647 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_646 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_645 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_644 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_643 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_642 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_641 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_640 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_639 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_638 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeClause_637 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeLogic_636 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeTruth_635 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeNumber_634 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeText_633 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_]\w*%(\_s*\.\_s*[A-Za-z_]\w*)*)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_]|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeReference_632 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_622,asemeComment_624 skipwhite skipempty
syntax match asemeClause_630 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_629,asemeComment_631 skipwhite skipempty
syntax region asemeComment_631 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_629,asemeComment_631 skipwhite skipempty
syntax match asemeComment_631 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_629,asemeComment_631 skipwhite skipempty
syntax match asemeReference_629 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_622,asemeComment_624 skipwhite skipempty
syntax match asemeClause_627 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_625,asemeComment_628 skipwhite skipempty
syntax region asemeComment_628 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_625,asemeComment_628 skipwhite skipempty
syntax match asemeComment_628 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_625,asemeComment_628 skipwhite skipempty
syntax match asemeReference_625 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_623,asemeComment_626 skipwhite skipempty
syntax region asemeComment_626 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_623,asemeComment_626 skipwhite skipempty
syntax match asemeComment_626 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_623,asemeComment_626 skipwhite skipempty
syntax match asemeReference_623 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_622,asemeComment_624 skipwhite skipempty
syntax region asemeComment_624 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_622,asemeComment_624 skipwhite skipempty
syntax match asemeComment_624 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_622,asemeComment_624 skipwhite skipempty
syntax region asemePunctuation_622 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax region asemeComment_621 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax match asemeComment_621 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_621 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_556,asemeNumber_558,asemeReference_559,asemeNumber_560,asemeOperator_561,asemePunctuation_562
syntax match asemePunctuation_562 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemeOperator_561 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemeNumber_560 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemeReference_559 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemeNumber_558 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemeText_556 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax region asemeComment_557 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax match asemeComment_557 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_557 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant contains=asemeClause_459,asemeClause_462,asemeReference_464,asemeText_465,asemeNumber_466,asemeTruth_467,asemeLogic_468,asemeClause_469,asemeClause_470,asemeClause_471,asemeClause_472,asemeClause_473,asemeClause_474,asemeClause_475,asemeClause_476,asemeClause_477,asemeClause_478,asemeClause_479,asemeClause_480,asemeClause_481,asemeClause_482,asemeCall_483,asemeReference_484,asemeOperator_485,asemePunctuation_486
syntax match asemePunctuation_486 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeOperator_485 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeReference_484 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeCall_483 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_482 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_481 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_480 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_479 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_478 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_477 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_476 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_475 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_474 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_473 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_472 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_471 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_470 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeClause_469 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeLogic_468 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeTruth_467 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeNumber_466 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeText_465 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeReference_464 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax match asemeClause_462 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_461,asemeComment_463 skipwhite skipempty
syntax region asemeComment_463 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_461,asemeComment_463 skipwhite skipempty
syntax match asemeComment_463 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_461,asemeComment_463 skipwhite skipempty
syntax match asemeReference_461 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax match asemeClause_459 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_457,asemeComment_460 skipwhite skipempty
syntax region asemeComment_460 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_457,asemeComment_460 skipwhite skipempty
syntax match asemeComment_460 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_457,asemeComment_460 skipwhite skipempty
syntax match asemeReference_457 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_455,asemeComment_458 skipwhite skipempty
syntax region asemeComment_458 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_455,asemeComment_458 skipwhite skipempty
syntax match asemeComment_458 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_455,asemeComment_458 skipwhite skipempty
syntax match asemeReference_455 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax region asemeComment_456 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax match asemeComment_456 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_454,asemeComment_456 skipwhite skipempty
syntax region asemePunctuation_454 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax region asemeComment_453 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax match asemeComment_453 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_453 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_399,asemeClause_402,asemeReference_404,asemeText_405,asemeNumber_406,asemeTruth_407,asemeLogic_408,asemeClause_409,asemeClause_410,asemeClause_411,asemeClause_412,asemeClause_413,asemeClause_414,asemeClause_415,asemeClause_416,asemeClause_417,asemeClause_418,asemeClause_419,asemeClause_420,asemeClause_421,asemeClause_422,asemeCall_423,asemeReference_424,asemeOperator_425,asemePunctuation_426
syntax match asemePunctuation_426 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeOperator_425 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeReference_424 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeCall_423 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_422 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_421 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_420 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_419 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_418 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_417 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_416 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_415 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_414 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_413 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_412 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_411 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_410 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeClause_409 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeLogic_408 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeTruth_407 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeNumber_406 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeText_405 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeReference_404 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_394,asemeComment_396 skipwhite skipempty
syntax match asemeClause_402 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_401,asemeComment_403 skipwhite skipempty
syntax region asemeComment_403 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_401,asemeComment_403 skipwhite skipempty
syntax match asemeComment_403 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_401,asemeComment_403 skipwhite skipempty
syntax match asemeReference_401 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_394,asemeComment_396 skipwhite skipempty
syntax match asemeClause_399 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_397,asemeComment_400 skipwhite skipempty
syntax region asemeComment_400 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_397,asemeComment_400 skipwhite skipempty
syntax match asemeComment_400 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_397,asemeComment_400 skipwhite skipempty
syntax match asemeReference_397 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_395,asemeComment_398 skipwhite skipempty
syntax region asemeComment_398 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_395,asemeComment_398 skipwhite skipempty
syntax match asemeComment_398 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_395,asemeComment_398 skipwhite skipempty
syntax match asemeReference_395 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_394,asemeComment_396 skipwhite skipempty
syntax region asemeComment_396 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_394,asemeComment_396 skipwhite skipempty
syntax match asemeComment_396 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_394,asemeComment_396 skipwhite skipempty
syntax region asemePunctuation_394 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_393 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeReference_313,asemeText_315,asemeNumber_316,asemeTruth_317,asemeLogic_318,asemeClause_319,asemeClause_320,asemeClause_321,asemeClause_322,asemeClause_323,asemeClause_324,asemeClause_325,asemeClause_326,asemeClause_327,asemeClause_328,asemeClause_329,asemeClause_330,asemeClause_331,asemeClause_332,asemeCall_333,asemeReference_334,asemeOperator_335,asemePunctuation_336
syntax match asemePunctuation_336 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeOperator_335 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeReference_334 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeCall_333 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_332 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_331 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_330 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_329 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_328 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_327 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_326 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_325 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_324 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_323 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_322 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_321 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_320 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeClause_319 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeLogic_318 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeTruth_317 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeNumber_316 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeText_315 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeReference_313 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_311,asemeComment_314 skipwhite skipempty
syntax region asemeComment_314 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_311,asemeComment_314 skipwhite skipempty
syntax match asemeComment_314 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_311,asemeComment_314 skipwhite skipempty
syntax match asemeReference_311 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_310,asemeComment_312 skipwhite skipempty
syntax region asemeComment_312 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_310,asemeComment_312 skipwhite skipempty
syntax match asemeComment_312 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_310,asemeComment_312 skipwhite skipempty
syntax region asemePunctuation_310 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax region asemeComment_309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax match asemeComment_309 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_309 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeClause_272,asemeClause_275,asemeReference_277,asemeText_278,asemeNumber_279,asemeTruth_280,asemeLogic_281,asemeClause_282,asemeClause_283,asemeClause_284,asemeClause_285,asemeClause_286,asemeClause_287,asemeClause_288,asemeClause_289,asemeClause_290,asemeClause_291,asemeClause_292,asemeClause_293,asemeClause_294,asemeClause_295,asemeCall_296,asemeReference_297,asemeOperator_298,asemePunctuation_299
syntax match asemePunctuation_299 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeOperator_298 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeReference_297 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeCall_296 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_295 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_294 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_293 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_292 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_291 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_290 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_289 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_288 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_287 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_286 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_285 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_284 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_283 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeClause_282 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeLogic_281 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeTruth_280 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeNumber_279 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeText_278 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeReference_277 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_267,asemeComment_269 skipwhite skipempty
syntax match asemeClause_275 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_274,asemeComment_276 skipwhite skipempty
syntax region asemeComment_276 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_274,asemeComment_276 skipwhite skipempty
syntax match asemeComment_276 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_274,asemeComment_276 skipwhite skipempty
syntax match asemeReference_274 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_267,asemeComment_269 skipwhite skipempty
syntax match asemeClause_272 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_270,asemeComment_273 skipwhite skipempty
syntax region asemeComment_273 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_270,asemeComment_273 skipwhite skipempty
syntax match asemeComment_273 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_270,asemeComment_273 skipwhite skipempty
syntax match asemeReference_270 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_268,asemeComment_271 skipwhite skipempty
syntax region asemeComment_271 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_268,asemeComment_271 skipwhite skipempty
syntax match asemeComment_271 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_268,asemeComment_271 skipwhite skipempty
syntax match asemeReference_268 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_267,asemeComment_269 skipwhite skipempty
syntax region asemeComment_269 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_267,asemeComment_269 skipwhite skipempty
syntax match asemeComment_269 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_267,asemeComment_269 skipwhite skipempty
syntax region asemePunctuation_267 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax region asemeComment_266 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax match asemeComment_266 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_266 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_50,asemeClause_53,asemeReference_55,asemeText_56,asemeNumber_57,asemeTruth_58,asemeLogic_59,asemeClause_60,asemeClause_61,asemeClause_62,asemeClause_63,asemeClause_64,asemeClause_65,asemeClause_66,asemeClause_67,asemeClause_68,asemeClause_69,asemeClause_70,asemeClause_71,asemeClause_72,asemeClause_73,asemeCall_74,asemeReference_75,asemeOperator_76,asemePunctuation_77
syntax match asemePunctuation_77 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeOperator_76 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeReference_75 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeCall_74 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_73 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_72 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_71 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_70 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_69 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_68 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_67 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_66 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_65 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_64 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_63 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=weight%(<|>)%(\_s+[0-9])@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeClause_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeLogic_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeTruth_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeNumber_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeText_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeReference_55 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_45,asemeComment_47 skipwhite skipempty
syntax match asemeClause_53 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_52,asemeComment_54 skipwhite skipempty
syntax region asemeComment_54 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_52,asemeComment_54 skipwhite skipempty
syntax match asemeComment_54 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_52,asemeComment_54 skipwhite skipempty
syntax match asemeReference_52 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_45,asemeComment_47 skipwhite skipempty
syntax match asemeClause_50 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_48,asemeComment_51 skipwhite skipempty
syntax region asemeComment_51 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_48,asemeComment_51 skipwhite skipempty
syntax match asemeComment_51 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_48,asemeComment_51 skipwhite skipempty
syntax match asemeReference_48 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_46,asemeComment_49 skipwhite skipempty
syntax region asemeComment_49 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_46,asemeComment_49 skipwhite skipempty
syntax match asemeComment_49 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_46,asemeComment_49 skipwhite skipempty
syntax match asemeReference_46 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_45,asemeComment_47 skipwhite skipempty
syntax region asemeComment_47 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_45,asemeComment_47 skipwhite skipempty
syntax match asemeComment_47 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_45,asemeComment_47 skipwhite skipempty
syntax region asemePunctuation_45 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax region asemeComment_44 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax match asemeComment_44 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_44 skipwhite skipempty
syntax cluster asemeContentOfAMessage contains=asemeReference_14,asemeText_16,asemeNumber_17,asemeTruth_18,asemeLogic_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeClause_23,asemeClause_24,asemeClause_25,asemeClause_26,asemeClause_27,asemeClause_28,asemeClause_29,asemeClause_30,asemeClause_31,asemeClause_32,asemeClause_33,asemeCall_34,asemeReference_35,asemeOperator_36,asemePunctuation_37,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_37 /\v%([^ \t{}])@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_36 /\v%([^ \t{}])@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_35 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeCall_34 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained
syntax match asemeClause_33 /\v%([^ \t{}])@=write_messages%(<|>)%(\_s*\.)@=/ contained
syntax match asemeClause_32 /\v%([^ \t{}])@=read_messages%(<|>)%(\_s*\()@!/ contained
syntax match asemeClause_31 /\v%([^ \t{}])@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_30 /\v%([^ \t{}])@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_29 /\v%([^ \t{}])@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_28 /\v%([^ \t{}])@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained
syntax match asemeClause_27 /\v%([^ \t{}])@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_26 /\v%([^ \t{}])@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_25 /\v%([^ \t{}])@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_24 /\v%([^ \t{}])@=ignores%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_23 /\v%([^ \t{}])@=weight%(<|>)%(\_s+[0-9])@=/ contained
syntax match asemeClause_22 /\v%([^ \t{}])@=after%(<|>)%(\_s*\()@=/ contained
syntax match asemeClause_21 /\v%([^ \t{}])@=when%(<|>)/ contained
syntax match asemeClause_20 /\v%([^ \t{}])@=else%(<|>)/ contained
syntax match asemeLogic_19 /\v%([^ \t{}])@=%(and|or|not)%(<|>)/ contained
syntax match asemeTruth_18 /\v%([^ \t{}])@=%(true|false)%(<|>)%(\_s*\.)@!/ contained
syntax match asemeNumber_17 /\v%([^ \t{}])@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_16 /\v%([^ \t{}])@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeReference_14 /\v%(%(liveness|activities|modules|sag|suc)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@=%(\_s*\{)@=/ contained nextgroup=asemePunctuation_13,asemeComment_15 skipwhite skipempty
syntax region asemeComment_15 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_13,asemeComment_15 skipwhite skipempty
syntax match asemeComment_15 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_13,asemeComment_15 skipwhite skipempty
syntax region asemePunctuation_13 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeContentOfAMessage
syntax region asemeComment start=/\v\/\*/ end=/\v\*\// contains=@Spell
syntax match asemeComment /\v\/\/.*$/ contains=@Spell
highlight default link asemeBlock_1075 asemeBlock
highlight default link asemeBlock_1077 asemeBlock
highlight default link asemeBlock_1089 asemeBlock
highlight default link asemeBlock_1095 asemeBlock
highlight default link asemeBlock_1100 asemeBlock
highlight default link asemeBlock_1101 asemeBlock
highlight default link asemeBlock_1106 asemeBlock
highlight default link asemeBlock_116 asemeBlock
highlight default link asemeBlock_118 asemeBlock
highlight default link asemeBlock_1253 asemeBlock
highlight default link asemeBlock_1255 asemeBlock
highlight default link asemeBlock_1325 asemeBlock
highlight default link asemeBlock_1327 asemeBlock
highlight default link asemeBlock_151 asemeBlock
highlight default link asemeBlock_152 asemeBlock
highlight default link asemeBlock_214 asemeBlock
highlight default link asemeBlock_216 asemeBlock
highlight default link asemeBlock_566 asemeBlock
highlight default link asemeBlock_567 asemeBlock
highlight default link asemeBlock_710 asemeBlock
highlight default link asemeBlock_716 asemeBlock
highlight default link asemeBlock_721 asemeBlock
highlight default link asemeBlock_723 asemeBlock
highlight default link asemeBlock_726 asemeBlock
highlight default link asemeBlock_90 asemeBlock
highlight default link asemeBlock_92 asemeBlock
highlight default link asemeBuiltIn_1008 asemeBuiltIn
highlight default link asemeBuiltIn_101 asemeBuiltIn
highlight default link asemeBuiltIn_106 asemeBuiltIn
highlight default link asemeBuiltIn_112 asemeBuiltIn
highlight default link asemeBuiltIn_1179 asemeBuiltIn
highlight default link asemeBuiltIn_1196 asemeBuiltIn
highlight default link asemeBuiltIn_159 asemeBuiltIn
highlight default link asemeBuiltIn_169 asemeBuiltIn
highlight default link asemeBuiltIn_175 asemeBuiltIn
highlight default link asemeBuiltIn_185 asemeBuiltIn
highlight default link asemeBuiltIn_368 asemeBuiltIn
highlight default link asemeBuiltIn_385 asemeBuiltIn
highlight default link asemeBuiltIn_432 asemeBuiltIn
highlight default link asemeBuiltIn_449 asemeBuiltIn
highlight default link asemeBuiltIn_488 asemeBuiltIn
highlight default link asemeBuiltIn_494 asemeBuiltIn
highlight default link asemeBuiltIn_496 asemeBuiltIn
highlight default link asemeBuiltIn_548 asemeBuiltIn
highlight default link asemeBuiltIn_856 asemeBuiltIn
highlight default link asemeBuiltIn_873 asemeBuiltIn
highlight default link asemeBuiltIn_929 asemeBuiltIn
highlight default link asemeBuiltIn_986 asemeBuiltIn
highlight default link asemeBuiltIn_994 asemeBuiltIn
highlight default link asemeCall_1170 asemeCall
highlight default link asemeCall_1234 asemeCall
highlight default link asemeCall_1288 asemeCall
highlight default link asemeCall_296 asemeCall
highlight default link asemeCall_333 asemeCall
highlight default link asemeCall_34 asemeCall
highlight default link asemeCall_423 asemeCall
highlight default link asemeCall_483 asemeCall
highlight default link asemeCall_651 asemeCall
highlight default link asemeCall_693 asemeCall
highlight default link asemeCall_74 asemeCall
highlight default link asemeCall_768 asemeCall
highlight default link asemeCall_805 asemeCall
highlight default link asemeCall_911 asemeCall
highlight default link asemeChoice_1001 asemeChoice
highlight default link asemeChoice_1020 asemeChoice
highlight default link asemeChoice_1034 asemeChoice
highlight default link asemeChoice_1041 asemeChoice
highlight default link asemeChoice_1053 asemeChoice
highlight default link asemeChoice_1054 asemeChoice
highlight default link asemeChoice_1056 asemeChoice
highlight default link asemeChoice_1115 asemeChoice
highlight default link asemeChoice_1119 asemeChoice
highlight default link asemeChoice_1127 asemeChoice
highlight default link asemeChoice_141 asemeChoice
highlight default link asemeChoice_222 asemeChoice
highlight default link asemeChoice_227 asemeChoice
highlight default link asemeChoice_573 asemeChoice
highlight default link asemeChoice_580 asemeChoice
highlight default link asemeChoice_951 asemeChoice
highlight default link asemeChoice_965 asemeChoice
highlight default link asemeChoice_972 asemeChoice
highlight default link asemeChoice_984 asemeChoice
highlight default link asemeChoice_985 asemeChoice
highlight default link asemeClause_1023 asemeClause
highlight default link asemeClause_1026 asemeClause
highlight default link asemeClause_1029 asemeClause
highlight default link asemeClause_1032 asemeClause
highlight default link asemeClause_1035 asemeClause
highlight default link asemeClause_1038 asemeClause
highlight default link asemeClause_1044 asemeClause
highlight default link asemeClause_1047 asemeClause
highlight default link asemeClause_1050 asemeClause
highlight default link asemeClause_1052 asemeClause
highlight default link asemeClause_1102 asemeClause
highlight default link asemeClause_1111 asemeClause
highlight default link asemeClause_1146 asemeClause
highlight default link asemeClause_1149 asemeClause
highlight default link asemeClause_1156 asemeClause
highlight default link asemeClause_1157 asemeClause
highlight default link asemeClause_1158 asemeClause
highlight default link asemeClause_1159 asemeClause
highlight default link asemeClause_1160 asemeClause
highlight default link asemeClause_1161 asemeClause
highlight default link asemeClause_1162 asemeClause
highlight default link asemeClause_1163 asemeClause
highlight default link asemeClause_1164 asemeClause
highlight default link asemeClause_1165 asemeClause
highlight default link asemeClause_1166 asemeClause
highlight default link asemeClause_1167 asemeClause
highlight default link asemeClause_1168 asemeClause
highlight default link asemeClause_1169 asemeClause
highlight default link asemeClause_1182 asemeClause
highlight default link asemeClause_1184 asemeClause
highlight default link asemeClause_1195 asemeClause
highlight default link asemeClause_1210 asemeClause
highlight default link asemeClause_1213 asemeClause
highlight default link asemeClause_1220 asemeClause
highlight default link asemeClause_1221 asemeClause
highlight default link asemeClause_1222 asemeClause
highlight default link asemeClause_1223 asemeClause
highlight default link asemeClause_1224 asemeClause
highlight default link asemeClause_1225 asemeClause
highlight default link asemeClause_1226 asemeClause
highlight default link asemeClause_1227 asemeClause
highlight default link asemeClause_1228 asemeClause
highlight default link asemeClause_1229 asemeClause
highlight default link asemeClause_123 asemeClause
highlight default link asemeClause_1230 asemeClause
highlight default link asemeClause_1231 asemeClause
highlight default link asemeClause_1232 asemeClause
highlight default link asemeClause_1233 asemeClause
highlight default link asemeClause_126 asemeClause
highlight default link asemeClause_1264 asemeClause
highlight default link asemeClause_1267 asemeClause
highlight default link asemeClause_1274 asemeClause
highlight default link asemeClause_1275 asemeClause
highlight default link asemeClause_1276 asemeClause
highlight default link asemeClause_1277 asemeClause
highlight default link asemeClause_1278 asemeClause
highlight default link asemeClause_1279 asemeClause
highlight default link asemeClause_1280 asemeClause
highlight default link asemeClause_1281 asemeClause
highlight default link asemeClause_1282 asemeClause
highlight default link asemeClause_1283 asemeClause
highlight default link asemeClause_1284 asemeClause
highlight default link asemeClause_1285 asemeClause
highlight default link asemeClause_1286 asemeClause
highlight default link asemeClause_1287 asemeClause
highlight default link asemeClause_129 asemeClause
highlight default link asemeClause_1295 asemeClause
highlight default link asemeClause_133 asemeClause
highlight default link asemeClause_136 asemeClause
highlight default link asemeClause_139 asemeClause
highlight default link asemeClause_198 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_200 asemeClause
highlight default link asemeClause_203 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_236 asemeClause
highlight default link asemeClause_239 asemeClause
highlight default link asemeClause_24 asemeClause
highlight default link asemeClause_242 asemeClause
highlight default link asemeClause_25 asemeClause
highlight default link asemeClause_26 asemeClause
highlight default link asemeClause_27 asemeClause
highlight default link asemeClause_272 asemeClause
highlight default link asemeClause_275 asemeClause
highlight default link asemeClause_28 asemeClause
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
highlight default link asemeClause_291 asemeClause
highlight default link asemeClause_292 asemeClause
highlight default link asemeClause_293 asemeClause
highlight default link asemeClause_294 asemeClause
highlight default link asemeClause_295 asemeClause
highlight default link asemeClause_30 asemeClause
highlight default link asemeClause_303 asemeClause
highlight default link asemeClause_307 asemeClause
highlight default link asemeClause_31 asemeClause
highlight default link asemeClause_319 asemeClause
highlight default link asemeClause_32 asemeClause
highlight default link asemeClause_320 asemeClause
highlight default link asemeClause_321 asemeClause
highlight default link asemeClause_322 asemeClause
highlight default link asemeClause_323 asemeClause
highlight default link asemeClause_324 asemeClause
highlight default link asemeClause_325 asemeClause
highlight default link asemeClause_326 asemeClause
highlight default link asemeClause_327 asemeClause
highlight default link asemeClause_328 asemeClause
highlight default link asemeClause_329 asemeClause
highlight default link asemeClause_33 asemeClause
highlight default link asemeClause_330 asemeClause
highlight default link asemeClause_331 asemeClause
highlight default link asemeClause_332 asemeClause
highlight default link asemeClause_337 asemeClause
highlight default link asemeClause_338 asemeClause
highlight default link asemeClause_340 asemeClause
highlight default link asemeClause_371 asemeClause
highlight default link asemeClause_373 asemeClause
highlight default link asemeClause_384 asemeClause
highlight default link asemeClause_399 asemeClause
highlight default link asemeClause_402 asemeClause
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
highlight default link asemeClause_420 asemeClause
highlight default link asemeClause_421 asemeClause
highlight default link asemeClause_422 asemeClause
highlight default link asemeClause_459 asemeClause
highlight default link asemeClause_462 asemeClause
highlight default link asemeClause_469 asemeClause
highlight default link asemeClause_470 asemeClause
highlight default link asemeClause_471 asemeClause
highlight default link asemeClause_472 asemeClause
highlight default link asemeClause_473 asemeClause
highlight default link asemeClause_474 asemeClause
highlight default link asemeClause_475 asemeClause
highlight default link asemeClause_476 asemeClause
highlight default link asemeClause_477 asemeClause
highlight default link asemeClause_478 asemeClause
highlight default link asemeClause_479 asemeClause
highlight default link asemeClause_480 asemeClause
highlight default link asemeClause_481 asemeClause
highlight default link asemeClause_482 asemeClause
highlight default link asemeClause_50 asemeClause
highlight default link asemeClause_511 asemeClause
highlight default link asemeClause_514 asemeClause
highlight default link asemeClause_516 asemeClause
highlight default link asemeClause_53 asemeClause
highlight default link asemeClause_576 asemeClause
highlight default link asemeClause_578 asemeClause
highlight default link asemeClause_582 asemeClause
highlight default link asemeClause_585 asemeClause
highlight default link asemeClause_587 asemeClause
highlight default link asemeClause_588 asemeClause
highlight default link asemeClause_591 asemeClause
highlight default link asemeClause_593 asemeClause
highlight default link asemeClause_594 asemeClause
highlight default link asemeClause_595 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_616 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_627 asemeClause
highlight default link asemeClause_63 asemeClause
highlight default link asemeClause_630 asemeClause
highlight default link asemeClause_637 asemeClause
highlight default link asemeClause_638 asemeClause
highlight default link asemeClause_639 asemeClause
highlight default link asemeClause_64 asemeClause
highlight default link asemeClause_640 asemeClause
highlight default link asemeClause_641 asemeClause
highlight default link asemeClause_642 asemeClause
highlight default link asemeClause_643 asemeClause
highlight default link asemeClause_644 asemeClause
highlight default link asemeClause_645 asemeClause
highlight default link asemeClause_646 asemeClause
highlight default link asemeClause_647 asemeClause
highlight default link asemeClause_648 asemeClause
highlight default link asemeClause_649 asemeClause
highlight default link asemeClause_65 asemeClause
highlight default link asemeClause_650 asemeClause
highlight default link asemeClause_66 asemeClause
highlight default link asemeClause_669 asemeClause
highlight default link asemeClause_67 asemeClause
highlight default link asemeClause_672 asemeClause
highlight default link asemeClause_679 asemeClause
highlight default link asemeClause_68 asemeClause
highlight default link asemeClause_680 asemeClause
highlight default link asemeClause_681 asemeClause
highlight default link asemeClause_682 asemeClause
highlight default link asemeClause_683 asemeClause
highlight default link asemeClause_684 asemeClause
highlight default link asemeClause_685 asemeClause
highlight default link asemeClause_686 asemeClause
highlight default link asemeClause_687 asemeClause
highlight default link asemeClause_688 asemeClause
highlight default link asemeClause_689 asemeClause
highlight default link asemeClause_69 asemeClause
highlight default link asemeClause_690 asemeClause
highlight default link asemeClause_691 asemeClause
highlight default link asemeClause_692 asemeClause
highlight default link asemeClause_70 asemeClause
highlight default link asemeClause_71 asemeClause
highlight default link asemeClause_72 asemeClause
highlight default link asemeClause_728 asemeClause
highlight default link asemeClause_73 asemeClause
highlight default link asemeClause_744 asemeClause
highlight default link asemeClause_747 asemeClause
highlight default link asemeClause_754 asemeClause
highlight default link asemeClause_755 asemeClause
highlight default link asemeClause_756 asemeClause
highlight default link asemeClause_757 asemeClause
highlight default link asemeClause_758 asemeClause
highlight default link asemeClause_759 asemeClause
highlight default link asemeClause_760 asemeClause
highlight default link asemeClause_761 asemeClause
highlight default link asemeClause_762 asemeClause
highlight default link asemeClause_763 asemeClause
highlight default link asemeClause_764 asemeClause
highlight default link asemeClause_765 asemeClause
highlight default link asemeClause_766 asemeClause
highlight default link asemeClause_767 asemeClause
highlight default link asemeClause_775 asemeClause
highlight default link asemeClause_779 asemeClause
highlight default link asemeClause_791 asemeClause
highlight default link asemeClause_792 asemeClause
highlight default link asemeClause_793 asemeClause
highlight default link asemeClause_794 asemeClause
highlight default link asemeClause_795 asemeClause
highlight default link asemeClause_796 asemeClause
highlight default link asemeClause_797 asemeClause
highlight default link asemeClause_798 asemeClause
highlight default link asemeClause_799 asemeClause
highlight default link asemeClause_8 asemeClause
highlight default link asemeClause_800 asemeClause
highlight default link asemeClause_801 asemeClause
highlight default link asemeClause_802 asemeClause
highlight default link asemeClause_803 asemeClause
highlight default link asemeClause_804 asemeClause
highlight default link asemeClause_809 asemeClause
highlight default link asemeClause_810 asemeClause
highlight default link asemeClause_812 asemeClause
highlight default link asemeClause_859 asemeClause
highlight default link asemeClause_861 asemeClause
highlight default link asemeClause_872 asemeClause
highlight default link asemeClause_887 asemeClause
highlight default link asemeClause_890 asemeClause
highlight default link asemeClause_897 asemeClause
highlight default link asemeClause_898 asemeClause
highlight default link asemeClause_899 asemeClause
highlight default link asemeClause_900 asemeClause
highlight default link asemeClause_901 asemeClause
highlight default link asemeClause_902 asemeClause
highlight default link asemeClause_903 asemeClause
highlight default link asemeClause_904 asemeClause
highlight default link asemeClause_905 asemeClause
highlight default link asemeClause_906 asemeClause
highlight default link asemeClause_907 asemeClause
highlight default link asemeClause_908 asemeClause
highlight default link asemeClause_909 asemeClause
highlight default link asemeClause_910 asemeClause
highlight default link asemeClause_954 asemeClause
highlight default link asemeClause_957 asemeClause
highlight default link asemeClause_960 asemeClause
highlight default link asemeClause_963 asemeClause
highlight default link asemeClause_966 asemeClause
highlight default link asemeClause_969 asemeClause
highlight default link asemeClause_975 asemeClause
highlight default link asemeClause_978 asemeClause
highlight default link asemeClause_981 asemeClause
highlight default link asemeClause_983 asemeClause
highlight default link asemeComment_1002 asemeComment
highlight default link asemeComment_1007 asemeComment
highlight default link asemeComment_1011 asemeComment
highlight default link asemeComment_1017 asemeComment
highlight default link asemeComment_1019 asemeComment
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_1021 asemeComment
highlight default link asemeComment_1024 asemeComment
highlight default link asemeComment_1027 asemeComment
highlight default link asemeComment_1030 asemeComment
highlight default link asemeComment_1033 asemeComment
highlight default link asemeComment_1036 asemeComment
highlight default link asemeComment_1039 asemeComment
highlight default link asemeComment_1042 asemeComment
highlight default link asemeComment_1045 asemeComment
highlight default link asemeComment_1048 asemeComment
highlight default link asemeComment_1051 asemeComment
highlight default link asemeComment_1057 asemeComment
highlight default link asemeComment_1062 asemeComment
highlight default link asemeComment_1065 asemeComment
highlight default link asemeComment_107 asemeComment
highlight default link asemeComment_1070 asemeComment
highlight default link asemeComment_1073 asemeComment
highlight default link asemeComment_1076 asemeComment
highlight default link asemeComment_1079 asemeComment
highlight default link asemeComment_1081 asemeComment
highlight default link asemeComment_1083 asemeComment
highlight default link asemeComment_1087 asemeComment
highlight default link asemeComment_1090 asemeComment
highlight default link asemeComment_1093 asemeComment
highlight default link asemeComment_1096 asemeComment
highlight default link asemeComment_1098 asemeComment
highlight default link asemeComment_110 asemeComment
highlight default link asemeComment_1103 asemeComment
highlight default link asemeComment_1105 asemeComment
highlight default link asemeComment_1108 asemeComment
highlight default link asemeComment_1110 asemeComment
highlight default link asemeComment_1112 asemeComment
highlight default link asemeComment_1116 asemeComment
highlight default link asemeComment_1120 asemeComment
highlight default link asemeComment_1122 asemeComment
highlight default link asemeComment_1128 asemeComment
highlight default link asemeComment_113 asemeComment
highlight default link asemeComment_1130 asemeComment
highlight default link asemeComment_1132 asemeComment
highlight default link asemeComment_1135 asemeComment
highlight default link asemeComment_1137 asemeComment
highlight default link asemeComment_1139 asemeComment
highlight default link asemeComment_1140 asemeComment
highlight default link asemeComment_1143 asemeComment
highlight default link asemeComment_1145 asemeComment
highlight default link asemeComment_1147 asemeComment
highlight default link asemeComment_1150 asemeComment
highlight default link asemeComment_117 asemeComment
highlight default link asemeComment_1176 asemeComment
highlight default link asemeComment_1178 asemeComment
highlight default link asemeComment_1180 asemeComment
highlight default link asemeComment_1183 asemeComment
highlight default link asemeComment_1187 asemeComment
highlight default link asemeComment_1189 asemeComment
highlight default link asemeComment_1192 asemeComment
highlight default link asemeComment_1194 asemeComment
highlight default link asemeComment_1199 asemeComment
highlight default link asemeComment_120 asemeComment
highlight default link asemeComment_1202 asemeComment
highlight default link asemeComment_1204 asemeComment
highlight default link asemeComment_1207 asemeComment
highlight default link asemeComment_1209 asemeComment
highlight default link asemeComment_1211 asemeComment
highlight default link asemeComment_1214 asemeComment
highlight default link asemeComment_122 asemeComment
highlight default link asemeComment_124 asemeComment
highlight default link asemeComment_1242 asemeComment
highlight default link asemeComment_1245 asemeComment
highlight default link asemeComment_1247 asemeComment
highlight default link asemeComment_1249 asemeComment
highlight default link asemeComment_1251 asemeComment
highlight default link asemeComment_1254 asemeComment
highlight default link asemeComment_1257 asemeComment
highlight default link asemeComment_1258 asemeComment
highlight default link asemeComment_1261 asemeComment
highlight default link asemeComment_1263 asemeComment
highlight default link asemeComment_1265 asemeComment
highlight default link asemeComment_1268 asemeComment
highlight default link asemeComment_127 asemeComment
highlight default link asemeComment_1294 asemeComment
highlight default link asemeComment_1296 asemeComment
highlight default link asemeComment_1298 asemeComment
highlight default link asemeComment_130 asemeComment
highlight default link asemeComment_1300 asemeComment
highlight default link asemeComment_1302 asemeComment
highlight default link asemeComment_1304 asemeComment
highlight default link asemeComment_1306 asemeComment
highlight default link asemeComment_1309 asemeComment
highlight default link asemeComment_1311 asemeComment
highlight default link asemeComment_1314 asemeComment
highlight default link asemeComment_1317 asemeComment
highlight default link asemeComment_132 asemeComment
highlight default link asemeComment_1320 asemeComment
highlight default link asemeComment_1326 asemeComment
highlight default link asemeComment_1329 asemeComment
highlight default link asemeComment_134 asemeComment
highlight default link asemeComment_1355 asemeComment
highlight default link asemeComment_1358 asemeComment
highlight default link asemeComment_1366 asemeComment
highlight default link asemeComment_1369 asemeComment
highlight default link asemeComment_137 asemeComment
highlight default link asemeComment_140 asemeComment
highlight default link asemeComment_145 asemeComment
highlight default link asemeComment_149 asemeComment
highlight default link asemeComment_15 asemeComment
highlight default link asemeComment_154 asemeComment
highlight default link asemeComment_156 asemeComment
highlight default link asemeComment_158 asemeComment
highlight default link asemeComment_160 asemeComment
highlight default link asemeComment_163 asemeComment
highlight default link asemeComment_165 asemeComment
highlight default link asemeComment_168 asemeComment
highlight default link asemeComment_170 asemeComment
highlight default link asemeComment_173 asemeComment
highlight default link asemeComment_176 asemeComment
highlight default link asemeComment_179 asemeComment
highlight default link asemeComment_182 asemeComment
highlight default link asemeComment_186 asemeComment
highlight default link asemeComment_190 asemeComment
highlight default link asemeComment_193 asemeComment
highlight default link asemeComment_195 asemeComment
highlight default link asemeComment_197 asemeComment
highlight default link asemeComment_199 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_201 asemeComment
highlight default link asemeComment_204 asemeComment
highlight default link asemeComment_207 asemeComment
highlight default link asemeComment_212 asemeComment
highlight default link asemeComment_215 asemeComment
highlight default link asemeComment_218 asemeComment
highlight default link asemeComment_221 asemeComment
highlight default link asemeComment_223 asemeComment
highlight default link asemeComment_226 asemeComment
highlight default link asemeComment_229 asemeComment
highlight default link asemeComment_233 asemeComment
highlight default link asemeComment_235 asemeComment
highlight default link asemeComment_237 asemeComment
highlight default link asemeComment_240 asemeComment
highlight default link asemeComment_243 asemeComment
highlight default link asemeComment_246 asemeComment
highlight default link asemeComment_251 asemeComment
highlight default link asemeComment_254 asemeComment
highlight default link asemeComment_256 asemeComment
highlight default link asemeComment_258 asemeComment
highlight default link asemeComment_261 asemeComment
highlight default link asemeComment_265 asemeComment
highlight default link asemeComment_266 asemeComment
highlight default link asemeComment_269 asemeComment
highlight default link asemeComment_271 asemeComment
highlight default link asemeComment_273 asemeComment
highlight default link asemeComment_276 asemeComment
highlight default link asemeComment_302 asemeComment
highlight default link asemeComment_304 asemeComment
highlight default link asemeComment_306 asemeComment
highlight default link asemeComment_308 asemeComment
highlight default link asemeComment_309 asemeComment
highlight default link asemeComment_312 asemeComment
highlight default link asemeComment_314 asemeComment
highlight default link asemeComment_339 asemeComment
highlight default link asemeComment_343 asemeComment
highlight default link asemeComment_345 asemeComment
highlight default link asemeComment_348 asemeComment
highlight default link asemeComment_350 asemeComment
highlight default link asemeComment_353 asemeComment
highlight default link asemeComment_357 asemeComment
highlight default link asemeComment_359 asemeComment
highlight default link asemeComment_363 asemeComment
highlight default link asemeComment_365 asemeComment
highlight default link asemeComment_367 asemeComment
highlight default link asemeComment_369 asemeComment
highlight default link asemeComment_372 asemeComment
highlight default link asemeComment_376 asemeComment
highlight default link asemeComment_378 asemeComment
highlight default link asemeComment_381 asemeComment
highlight default link asemeComment_383 asemeComment
highlight default link asemeComment_388 asemeComment
highlight default link asemeComment_391 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_396 asemeComment
highlight default link asemeComment_398 asemeComment
highlight default link asemeComment_400 asemeComment
highlight default link asemeComment_403 asemeComment
highlight default link asemeComment_431 asemeComment
highlight default link asemeComment_435 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_439 asemeComment
highlight default link asemeComment_44 asemeComment
highlight default link asemeComment_441 asemeComment
highlight default link asemeComment_443 asemeComment
highlight default link asemeComment_445 asemeComment
highlight default link asemeComment_448 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_453 asemeComment
highlight default link asemeComment_456 asemeComment
highlight default link asemeComment_458 asemeComment
highlight default link asemeComment_460 asemeComment
highlight default link asemeComment_463 asemeComment
highlight default link asemeComment_47 asemeComment
highlight default link asemeComment_49 asemeComment
highlight default link asemeComment_491 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_501 asemeComment
highlight default link asemeComment_503 asemeComment
highlight default link asemeComment_506 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_51 asemeComment
highlight default link asemeComment_510 asemeComment
highlight default link asemeComment_512 asemeComment
highlight default link asemeComment_515 asemeComment
highlight default link asemeComment_519 asemeComment
highlight default link asemeComment_521 asemeComment
highlight default link asemeComment_524 asemeComment
highlight default link asemeComment_527 asemeComment
highlight default link asemeComment_529 asemeComment
highlight default link asemeComment_531 asemeComment
highlight default link asemeComment_533 asemeComment
highlight default link asemeComment_535 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_54 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_543 asemeComment
highlight default link asemeComment_545 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_551 asemeComment
highlight default link asemeComment_554 asemeComment
highlight default link asemeComment_557 asemeComment
highlight default link asemeComment_569 asemeComment
highlight default link asemeComment_572 asemeComment
highlight default link asemeComment_574 asemeComment
highlight default link asemeComment_577 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_583 asemeComment
highlight default link asemeComment_586 asemeComment
highlight default link asemeComment_589 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_609 asemeComment
highlight default link asemeComment_611 asemeComment
highlight default link asemeComment_613 asemeComment
highlight default link asemeComment_615 asemeComment
highlight default link asemeComment_617 asemeComment
highlight default link asemeComment_620 asemeComment
highlight default link asemeComment_621 asemeComment
highlight default link asemeComment_624 asemeComment
highlight default link asemeComment_626 asemeComment
highlight default link asemeComment_628 asemeComment
highlight default link asemeComment_631 asemeComment
highlight default link asemeComment_663 asemeComment
highlight default link asemeComment_666 asemeComment
highlight default link asemeComment_668 asemeComment
highlight default link asemeComment_670 asemeComment
highlight default link asemeComment_673 asemeComment
highlight default link asemeComment_699 asemeComment
highlight default link asemeComment_7 asemeComment
highlight default link asemeComment_701 asemeComment
highlight default link asemeComment_703 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_711 asemeComment
highlight default link asemeComment_714 asemeComment
highlight default link asemeComment_717 asemeComment
highlight default link asemeComment_719 asemeComment
highlight default link asemeComment_722 asemeComment
highlight default link asemeComment_725 asemeComment
highlight default link asemeComment_727 asemeComment
highlight default link asemeComment_729 asemeComment
highlight default link asemeComment_731 asemeComment
highlight default link asemeComment_733 asemeComment
highlight default link asemeComment_737 asemeComment
highlight default link asemeComment_738 asemeComment
highlight default link asemeComment_741 asemeComment
highlight default link asemeComment_743 asemeComment
highlight default link asemeComment_745 asemeComment
highlight default link asemeComment_748 asemeComment
highlight default link asemeComment_774 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_778 asemeComment
highlight default link asemeComment_780 asemeComment
highlight default link asemeComment_781 asemeComment
highlight default link asemeComment_784 asemeComment
highlight default link asemeComment_786 asemeComment
highlight default link asemeComment_80 asemeComment
highlight default link asemeComment_811 asemeComment
highlight default link asemeComment_815 asemeComment
highlight default link asemeComment_817 asemeComment
highlight default link asemeComment_82 asemeComment
highlight default link asemeComment_820 asemeComment
highlight default link asemeComment_822 asemeComment
highlight default link asemeComment_825 asemeComment
highlight default link asemeComment_829 asemeComment
highlight default link asemeComment_831 asemeComment
highlight default link asemeComment_835 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_839 asemeComment
highlight default link asemeComment_84 asemeComment
highlight default link asemeComment_841 asemeComment
highlight default link asemeComment_843 asemeComment
highlight default link asemeComment_846 asemeComment
highlight default link asemeComment_850 asemeComment
highlight default link asemeComment_853 asemeComment
highlight default link asemeComment_855 asemeComment
highlight default link asemeComment_857 asemeComment
highlight default link asemeComment_86 asemeComment
highlight default link asemeComment_860 asemeComment
highlight default link asemeComment_864 asemeComment
highlight default link asemeComment_866 asemeComment
highlight default link asemeComment_869 asemeComment
highlight default link asemeComment_871 asemeComment
highlight default link asemeComment_876 asemeComment
highlight default link asemeComment_879 asemeComment
highlight default link asemeComment_881 asemeComment
highlight default link asemeComment_884 asemeComment
highlight default link asemeComment_886 asemeComment
highlight default link asemeComment_888 asemeComment
highlight default link asemeComment_891 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_91 asemeComment
highlight default link asemeComment_919 asemeComment
highlight default link asemeComment_922 asemeComment
highlight default link asemeComment_924 asemeComment
highlight default link asemeComment_926 asemeComment
highlight default link asemeComment_928 asemeComment
highlight default link asemeComment_932 asemeComment
highlight default link asemeComment_935 asemeComment
highlight default link asemeComment_938 asemeComment
highlight default link asemeComment_94 asemeComment
highlight default link asemeComment_948 asemeComment
highlight default link asemeComment_950 asemeComment
highlight default link asemeComment_952 asemeComment
highlight default link asemeComment_955 asemeComment
highlight default link asemeComment_958 asemeComment
highlight default link asemeComment_96 asemeComment
highlight default link asemeComment_961 asemeComment
highlight default link asemeComment_964 asemeComment
highlight default link asemeComment_967 asemeComment
highlight default link asemeComment_970 asemeComment
highlight default link asemeComment_973 asemeComment
highlight default link asemeComment_976 asemeComment
highlight default link asemeComment_979 asemeComment
highlight default link asemeComment_98 asemeComment
highlight default link asemeComment_982 asemeComment
highlight default link asemeComment_989 asemeComment
highlight default link asemeComment_991 asemeComment
highlight default link asemeComment_993 asemeComment
highlight default link asemeComment_997 asemeComment
highlight default link asemeComment_999 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_1016 asemeDeclaration
highlight default link asemeDeclaration_1069 asemeDeclaration
highlight default link asemeDeclaration_1072 asemeDeclaration
highlight default link asemeDeclaration_1078 asemeDeclaration
highlight default link asemeDeclaration_109 asemeDeclaration
highlight default link asemeDeclaration_1097 asemeDeclaration
highlight default link asemeDeclaration_1104 asemeDeclaration
highlight default link asemeDeclaration_1107 asemeDeclaration
highlight default link asemeDeclaration_1131 asemeDeclaration
highlight default link asemeDeclaration_1177 asemeDeclaration
highlight default link asemeDeclaration_119 asemeDeclaration
highlight default link asemeDeclaration_12 asemeDeclaration
highlight default link asemeDeclaration_1241 asemeDeclaration
highlight default link asemeDeclaration_1246 asemeDeclaration
highlight default link asemeDeclaration_1248 asemeDeclaration
highlight default link asemeDeclaration_1250 asemeDeclaration
highlight default link asemeDeclaration_1256 asemeDeclaration
highlight default link asemeDeclaration_1328 asemeDeclaration
highlight default link asemeDeclaration_1357 asemeDeclaration
highlight default link asemeDeclaration_1368 asemeDeclaration
highlight default link asemeDeclaration_148 asemeDeclaration
highlight default link asemeDeclaration_153 asemeDeclaration
highlight default link asemeDeclaration_194 asemeDeclaration
highlight default link asemeDeclaration_211 asemeDeclaration
highlight default link asemeDeclaration_217 asemeDeclaration
highlight default link asemeDeclaration_220 asemeDeclaration
highlight default link asemeDeclaration_232 asemeDeclaration
highlight default link asemeDeclaration_250 asemeDeclaration
highlight default link asemeDeclaration_253 asemeDeclaration
highlight default link asemeDeclaration_264 asemeDeclaration
highlight default link asemeDeclaration_366 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_430 asemeDeclaration
highlight default link asemeDeclaration_438 asemeDeclaration
highlight default link asemeDeclaration_502 asemeDeclaration
highlight default link asemeDeclaration_507 asemeDeclaration
highlight default link asemeDeclaration_528 asemeDeclaration
highlight default link asemeDeclaration_542 asemeDeclaration
highlight default link asemeDeclaration_568 asemeDeclaration
highlight default link asemeDeclaration_571 asemeDeclaration
highlight default link asemeDeclaration_604 asemeDeclaration
highlight default link asemeDeclaration_608 asemeDeclaration
highlight default link asemeDeclaration_662 asemeDeclaration
highlight default link asemeDeclaration_718 asemeDeclaration
highlight default link asemeDeclaration_724 asemeDeclaration
highlight default link asemeDeclaration_736 asemeDeclaration
highlight default link asemeDeclaration_81 asemeDeclaration
highlight default link asemeDeclaration_838 asemeDeclaration
highlight default link asemeDeclaration_854 asemeDeclaration
highlight default link asemeDeclaration_918 asemeDeclaration
highlight default link asemeDeclaration_923 asemeDeclaration
highlight default link asemeDeclaration_93 asemeDeclaration
highlight default link asemeDeclaration_947 asemeDeclaration
highlight default link asemeLogic_1155 asemeLogic
highlight default link asemeLogic_1219 asemeLogic
highlight default link asemeLogic_1273 asemeLogic
highlight default link asemeLogic_19 asemeLogic
highlight default link asemeLogic_281 asemeLogic
highlight default link asemeLogic_318 asemeLogic
highlight default link asemeLogic_408 asemeLogic
highlight default link asemeLogic_468 asemeLogic
highlight default link asemeLogic_59 asemeLogic
highlight default link asemeLogic_636 asemeLogic
highlight default link asemeLogic_678 asemeLogic
highlight default link asemeLogic_753 asemeLogic
highlight default link asemeLogic_790 asemeLogic
highlight default link asemeLogic_896 asemeLogic
highlight default link asemeName_100 asemeName
highlight default link asemeName_1014 asemeName
highlight default link asemeName_104 asemeName
highlight default link asemeName_105 asemeName
highlight default link asemeName_1067 asemeName
highlight default link asemeName_111 asemeName
highlight default link asemeName_1113 asemeName
highlight default link asemeName_1117 asemeName
highlight default link asemeName_1123 asemeName
highlight default link asemeName_1125 asemeName
highlight default link asemeName_1239 asemeName
highlight default link asemeName_1240 asemeName
highlight default link asemeName_1244 asemeName
highlight default link asemeName_1293 asemeName
highlight default link asemeName_1313 asemeName
highlight default link asemeName_1315 asemeName
highlight default link asemeName_1323 asemeName
highlight default link asemeName_174 asemeName
highlight default link asemeName_184 asemeName
highlight default link asemeName_189 asemeName
highlight default link asemeName_192 asemeName
highlight default link asemeName_209 asemeName
highlight default link asemeName_210 asemeName
highlight default link asemeName_248 asemeName
highlight default link asemeName_249 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_428 asemeName
highlight default link asemeName_429 asemeName
highlight default link asemeName_436 asemeName
highlight default link asemeName_492 asemeName
highlight default link asemeName_500 asemeName
highlight default link asemeName_505 asemeName
highlight default link asemeName_544 asemeName
highlight default link asemeName_552 asemeName
highlight default link asemeName_564 asemeName
highlight default link asemeName_584 asemeName
highlight default link asemeName_596 asemeName
highlight default link asemeName_603 asemeName
highlight default link asemeName_606 asemeName
highlight default link asemeName_79 asemeName
highlight default link asemeName_849 asemeName
highlight default link asemeName_852 asemeName
highlight default link asemeName_88 asemeName
highlight default link asemeName_916 asemeName
highlight default link asemeName_917 asemeName
highlight default link asemeName_921 asemeName
highlight default link asemeName_925 asemeName
highlight default link asemeName_933 asemeName
highlight default link asemeName_945 asemeName
highlight default link asemeName_990 asemeName
highlight default link asemeName_998 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1025 asemeNumber
highlight default link asemeNumber_1028 asemeNumber
highlight default link asemeNumber_1031 asemeNumber
highlight default link asemeNumber_1043 asemeNumber
highlight default link asemeNumber_1121 asemeNumber
highlight default link asemeNumber_1129 asemeNumber
highlight default link asemeNumber_1134 asemeNumber
highlight default link asemeNumber_1138 asemeNumber
highlight default link asemeNumber_1153 asemeNumber
highlight default link asemeNumber_1175 asemeNumber
highlight default link asemeNumber_1186 asemeNumber
highlight default link asemeNumber_1190 asemeNumber
highlight default link asemeNumber_1193 asemeNumber
highlight default link asemeNumber_1200 asemeNumber
highlight default link asemeNumber_1217 asemeNumber
highlight default link asemeNumber_125 asemeNumber
highlight default link asemeNumber_1271 asemeNumber
highlight default link asemeNumber_128 asemeNumber
highlight default link asemeNumber_1299 asemeNumber
highlight default link asemeNumber_1303 asemeNumber
highlight default link asemeNumber_1308 asemeNumber
highlight default link asemeNumber_1331 asemeNumber
highlight default link asemeNumber_1337 asemeNumber
highlight default link asemeNumber_1343 asemeNumber
highlight default link asemeNumber_1349 asemeNumber
highlight default link asemeNumber_135 asemeNumber
highlight default link asemeNumber_1360 asemeNumber
highlight default link asemeNumber_1372 asemeNumber
highlight default link asemeNumber_138 asemeNumber
highlight default link asemeNumber_17 asemeNumber
highlight default link asemeNumber_255 asemeNumber
highlight default link asemeNumber_259 asemeNumber
highlight default link asemeNumber_279 asemeNumber
highlight default link asemeNumber_316 asemeNumber
highlight default link asemeNumber_375 asemeNumber
highlight default link asemeNumber_379 asemeNumber
highlight default link asemeNumber_382 asemeNumber
highlight default link asemeNumber_389 asemeNumber
highlight default link asemeNumber_40 asemeNumber
highlight default link asemeNumber_406 asemeNumber
highlight default link asemeNumber_440 asemeNumber
highlight default link asemeNumber_444 asemeNumber
highlight default link asemeNumber_446 asemeNumber
highlight default link asemeNumber_466 asemeNumber
highlight default link asemeNumber_558 asemeNumber
highlight default link asemeNumber_560 asemeNumber
highlight default link asemeNumber_57 asemeNumber
highlight default link asemeNumber_575 asemeNumber
highlight default link asemeNumber_581 asemeNumber
highlight default link asemeNumber_590 asemeNumber
highlight default link asemeNumber_614 asemeNumber
highlight default link asemeNumber_618 asemeNumber
highlight default link asemeNumber_634 asemeNumber
highlight default link asemeNumber_657 asemeNumber
highlight default link asemeNumber_659 asemeNumber
highlight default link asemeNumber_676 asemeNumber
highlight default link asemeNumber_698 asemeNumber
highlight default link asemeNumber_702 asemeNumber
highlight default link asemeNumber_751 asemeNumber
highlight default link asemeNumber_788 asemeNumber
highlight default link asemeNumber_83 asemeNumber
highlight default link asemeNumber_863 asemeNumber
highlight default link asemeNumber_867 asemeNumber
highlight default link asemeNumber_870 asemeNumber
highlight default link asemeNumber_877 asemeNumber
highlight default link asemeNumber_894 asemeNumber
highlight default link asemeNumber_939 asemeNumber
highlight default link asemeNumber_941 asemeNumber
highlight default link asemeNumber_95 asemeNumber
highlight default link asemeNumber_956 asemeNumber
highlight default link asemeNumber_959 asemeNumber
highlight default link asemeNumber_962 asemeNumber
highlight default link asemeNumber_974 asemeNumber
highlight default link asemeOperator_1064 asemeOperator
highlight default link asemeOperator_1080 asemeOperator
highlight default link asemeOperator_1082 asemeOperator
highlight default link asemeOperator_1084 asemeOperator
highlight default link asemeOperator_1085 asemeOperator
highlight default link asemeOperator_1086 asemeOperator
highlight default link asemeOperator_1088 asemeOperator
highlight default link asemeOperator_1091 asemeOperator
highlight default link asemeOperator_1092 asemeOperator
highlight default link asemeOperator_1094 asemeOperator
highlight default link asemeOperator_1136 asemeOperator
highlight default link asemeOperator_1172 asemeOperator
highlight default link asemeOperator_1236 asemeOperator
highlight default link asemeOperator_1238 asemeOperator
highlight default link asemeOperator_1243 asemeOperator
highlight default link asemeOperator_1290 asemeOperator
highlight default link asemeOperator_1292 asemeOperator
highlight default link asemeOperator_1312 asemeOperator
highlight default link asemeOperator_1322 asemeOperator
highlight default link asemeOperator_1333 asemeOperator
highlight default link asemeOperator_1339 asemeOperator
highlight default link asemeOperator_1345 asemeOperator
highlight default link asemeOperator_1351 asemeOperator
highlight default link asemeOperator_1362 asemeOperator
highlight default link asemeOperator_157 asemeOperator
highlight default link asemeOperator_167 asemeOperator
highlight default link asemeOperator_181 asemeOperator
highlight default link asemeOperator_298 asemeOperator
highlight default link asemeOperator_300 asemeOperator
highlight default link asemeOperator_335 asemeOperator
highlight default link asemeOperator_346 asemeOperator
highlight default link asemeOperator_354 asemeOperator
highlight default link asemeOperator_36 asemeOperator
highlight default link asemeOperator_425 asemeOperator
highlight default link asemeOperator_427 asemeOperator
highlight default link asemeOperator_485 asemeOperator
highlight default link asemeOperator_487 asemeOperator
highlight default link asemeOperator_504 asemeOperator
highlight default link asemeOperator_561 asemeOperator
highlight default link asemeOperator_563 asemeOperator
highlight default link asemeOperator_600 asemeOperator
highlight default link asemeOperator_605 asemeOperator
highlight default link asemeOperator_610 asemeOperator
highlight default link asemeOperator_612 asemeOperator
highlight default link asemeOperator_619 asemeOperator
highlight default link asemeOperator_653 asemeOperator
highlight default link asemeOperator_660 asemeOperator
highlight default link asemeOperator_695 asemeOperator
highlight default link asemeOperator_700 asemeOperator
highlight default link asemeOperator_705 asemeOperator
highlight default link asemeOperator_706 asemeOperator
highlight default link asemeOperator_707 asemeOperator
highlight default link asemeOperator_709 asemeOperator
highlight default link asemeOperator_712 asemeOperator
highlight default link asemeOperator_713 asemeOperator
highlight default link asemeOperator_715 asemeOperator
highlight default link asemeOperator_76 asemeOperator
highlight default link asemeOperator_770 asemeOperator
highlight default link asemeOperator_772 asemeOperator
highlight default link asemeOperator_78 asemeOperator
highlight default link asemeOperator_807 asemeOperator
highlight default link asemeOperator_818 asemeOperator
highlight default link asemeOperator_826 asemeOperator
highlight default link asemeOperator_842 asemeOperator
highlight default link asemeOperator_85 asemeOperator
highlight default link asemeOperator_913 asemeOperator
highlight default link asemeOperator_915 asemeOperator
highlight default link asemeOperator_920 asemeOperator
highlight default link asemeOperator_942 asemeOperator
highlight default link asemeOperator_944 asemeOperator
highlight default link asemeOperator_97 asemeOperator
highlight default link asemePunctuation_1006 asemePunctuation
highlight default link asemePunctuation_1010 asemePunctuation
highlight default link asemePunctuation_1012 asemePunctuation
highlight default link asemePunctuation_1015 asemePunctuation
highlight default link asemePunctuation_1061 asemePunctuation
highlight default link asemePunctuation_1068 asemePunctuation
highlight default link asemePunctuation_1074 asemePunctuation
highlight default link asemePunctuation_1099 asemePunctuation
highlight default link asemePunctuation_1133 asemePunctuation
highlight default link asemePunctuation_1141 asemePunctuation
highlight default link asemePunctuation_115 asemePunctuation
highlight default link asemePunctuation_1173 asemePunctuation
highlight default link asemePunctuation_1174 asemePunctuation
highlight default link asemePunctuation_1185 asemePunctuation
highlight default link asemePunctuation_1188 asemePunctuation
highlight default link asemePunctuation_1191 asemePunctuation
highlight default link asemePunctuation_1198 asemePunctuation
highlight default link asemePunctuation_1201 asemePunctuation
highlight default link asemePunctuation_1203 asemePunctuation
highlight default link asemePunctuation_1205 asemePunctuation
highlight default link asemePunctuation_1237 asemePunctuation
highlight default link asemePunctuation_1252 asemePunctuation
highlight default link asemePunctuation_1259 asemePunctuation
highlight default link asemePunctuation_1291 asemePunctuation
highlight default link asemePunctuation_1297 asemePunctuation
highlight default link asemePunctuation_13 asemePunctuation
highlight default link asemePunctuation_1301 asemePunctuation
highlight default link asemePunctuation_1305 asemePunctuation
highlight default link asemePunctuation_1307 asemePunctuation
highlight default link asemePunctuation_1310 asemePunctuation
highlight default link asemePunctuation_1316 asemePunctuation
highlight default link asemePunctuation_1319 asemePunctuation
highlight default link asemePunctuation_1321 asemePunctuation
highlight default link asemePunctuation_1324 asemePunctuation
highlight default link asemePunctuation_1334 asemePunctuation
highlight default link asemePunctuation_1335 asemePunctuation
highlight default link asemePunctuation_1340 asemePunctuation
highlight default link asemePunctuation_1341 asemePunctuation
highlight default link asemePunctuation_1346 asemePunctuation
highlight default link asemePunctuation_1347 asemePunctuation
highlight default link asemePunctuation_1352 asemePunctuation
highlight default link asemePunctuation_1353 asemePunctuation
highlight default link asemePunctuation_1363 asemePunctuation
highlight default link asemePunctuation_1364 asemePunctuation
highlight default link asemePunctuation_1375 asemePunctuation
highlight default link asemePunctuation_144 asemePunctuation
highlight default link asemePunctuation_150 asemePunctuation
highlight default link asemePunctuation_162 asemePunctuation
highlight default link asemePunctuation_164 asemePunctuation
highlight default link asemePunctuation_172 asemePunctuation
highlight default link asemePunctuation_178 asemePunctuation
highlight default link asemePunctuation_183 asemePunctuation
highlight default link asemePunctuation_188 asemePunctuation
highlight default link asemePunctuation_191 asemePunctuation
highlight default link asemePunctuation_206 asemePunctuation
highlight default link asemePunctuation_213 asemePunctuation
highlight default link asemePunctuation_219 asemePunctuation
highlight default link asemePunctuation_225 asemePunctuation
highlight default link asemePunctuation_228 asemePunctuation
highlight default link asemePunctuation_245 asemePunctuation
highlight default link asemePunctuation_252 asemePunctuation
highlight default link asemePunctuation_257 asemePunctuation
highlight default link asemePunctuation_260 asemePunctuation
highlight default link asemePunctuation_262 asemePunctuation
highlight default link asemePunctuation_267 asemePunctuation
highlight default link asemePunctuation_299 asemePunctuation
highlight default link asemePunctuation_310 asemePunctuation
highlight default link asemePunctuation_336 asemePunctuation
highlight default link asemePunctuation_342 asemePunctuation
highlight default link asemePunctuation_349 asemePunctuation
highlight default link asemePunctuation_352 asemePunctuation
highlight default link asemePunctuation_356 asemePunctuation
highlight default link asemePunctuation_362 asemePunctuation
highlight default link asemePunctuation_37 asemePunctuation
highlight default link asemePunctuation_374 asemePunctuation
highlight default link asemePunctuation_377 asemePunctuation
highlight default link asemePunctuation_380 asemePunctuation
highlight default link asemePunctuation_387 asemePunctuation
highlight default link asemePunctuation_390 asemePunctuation
highlight default link asemePunctuation_392 asemePunctuation
highlight default link asemePunctuation_394 asemePunctuation
highlight default link asemePunctuation_426 asemePunctuation
highlight default link asemePunctuation_43 asemePunctuation
highlight default link asemePunctuation_434 asemePunctuation
highlight default link asemePunctuation_442 asemePunctuation
highlight default link asemePunctuation_447 asemePunctuation
highlight default link asemePunctuation_45 asemePunctuation
highlight default link asemePunctuation_451 asemePunctuation
highlight default link asemePunctuation_454 asemePunctuation
highlight default link asemePunctuation_486 asemePunctuation
highlight default link asemePunctuation_490 asemePunctuation
highlight default link asemePunctuation_498 asemePunctuation
highlight default link asemePunctuation_520 asemePunctuation
highlight default link asemePunctuation_534 asemePunctuation
highlight default link asemePunctuation_546 asemePunctuation
highlight default link asemePunctuation_550 asemePunctuation
highlight default link asemePunctuation_553 asemePunctuation
highlight default link asemePunctuation_555 asemePunctuation
highlight default link asemePunctuation_562 asemePunctuation
highlight default link asemePunctuation_565 asemePunctuation
highlight default link asemePunctuation_597 asemePunctuation
highlight default link asemePunctuation_602 asemePunctuation
highlight default link asemePunctuation_622 asemePunctuation
highlight default link asemePunctuation_654 asemePunctuation
highlight default link asemePunctuation_655 asemePunctuation
highlight default link asemePunctuation_661 asemePunctuation
highlight default link asemePunctuation_664 asemePunctuation
highlight default link asemePunctuation_696 asemePunctuation
highlight default link asemePunctuation_697 asemePunctuation
highlight default link asemePunctuation_704 asemePunctuation
highlight default link asemePunctuation_720 asemePunctuation
highlight default link asemePunctuation_732 asemePunctuation
highlight default link asemePunctuation_739 asemePunctuation
highlight default link asemePunctuation_77 asemePunctuation
highlight default link asemePunctuation_771 asemePunctuation
highlight default link asemePunctuation_782 asemePunctuation
highlight default link asemePunctuation_808 asemePunctuation
highlight default link asemePunctuation_814 asemePunctuation
highlight default link asemePunctuation_821 asemePunctuation
highlight default link asemePunctuation_824 asemePunctuation
highlight default link asemePunctuation_828 asemePunctuation
highlight default link asemePunctuation_834 asemePunctuation
highlight default link asemePunctuation_845 asemePunctuation
highlight default link asemePunctuation_862 asemePunctuation
highlight default link asemePunctuation_865 asemePunctuation
highlight default link asemePunctuation_868 asemePunctuation
highlight default link asemePunctuation_87 asemePunctuation
highlight default link asemePunctuation_875 asemePunctuation
highlight default link asemePunctuation_878 asemePunctuation
highlight default link asemePunctuation_880 asemePunctuation
highlight default link asemePunctuation_882 asemePunctuation
highlight default link asemePunctuation_89 asemePunctuation
highlight default link asemePunctuation_914 asemePunctuation
highlight default link asemePunctuation_927 asemePunctuation
highlight default link asemePunctuation_931 asemePunctuation
highlight default link asemePunctuation_934 asemePunctuation
highlight default link asemePunctuation_936 asemePunctuation
highlight default link asemePunctuation_943 asemePunctuation
highlight default link asemePunctuation_946 asemePunctuation
highlight default link asemePunctuation_988 asemePunctuation
highlight default link asemePunctuation_99 asemePunctuation
highlight default link asemePunctuation_992 asemePunctuation
highlight default link asemePunctuation_996 asemePunctuation
highlight default link asemeReference_1000 asemeReference
highlight default link asemeReference_1003 asemeReference
highlight default link asemeReference_1004 asemeReference
highlight default link asemeReference_1005 asemeReference
highlight default link asemeReference_1013 asemeReference
highlight default link asemeReference_1018 asemeReference
highlight default link asemeReference_1022 asemeReference
highlight default link asemeReference_1037 asemeReference
highlight default link asemeReference_1040 asemeReference
highlight default link asemeReference_1046 asemeReference
highlight default link asemeReference_1049 asemeReference
highlight default link asemeReference_1055 asemeReference
highlight default link asemeReference_1058 asemeReference
highlight default link asemeReference_1059 asemeReference
highlight default link asemeReference_1060 asemeReference
highlight default link asemeReference_1066 asemeReference
highlight default link asemeReference_11 asemeReference
highlight default link asemeReference_1109 asemeReference
highlight default link asemeReference_1142 asemeReference
highlight default link asemeReference_1144 asemeReference
highlight default link asemeReference_1148 asemeReference
highlight default link asemeReference_1151 asemeReference
highlight default link asemeReference_1171 asemeReference
highlight default link asemeReference_1206 asemeReference
highlight default link asemeReference_1208 asemeReference
highlight default link asemeReference_121 asemeReference
highlight default link asemeReference_1212 asemeReference
highlight default link asemeReference_1215 asemeReference
highlight default link asemeReference_1235 asemeReference
highlight default link asemeReference_1260 asemeReference
highlight default link asemeReference_1262 asemeReference
highlight default link asemeReference_1266 asemeReference
highlight default link asemeReference_1269 asemeReference
highlight default link asemeReference_1289 asemeReference
highlight default link asemeReference_131 asemeReference
highlight default link asemeReference_1318 asemeReference
highlight default link asemeReference_1332 asemeReference
highlight default link asemeReference_1338 asemeReference
highlight default link asemeReference_1344 asemeReference
highlight default link asemeReference_1350 asemeReference
highlight default link asemeReference_1361 asemeReference
highlight default link asemeReference_1373 asemeReference
highlight default link asemeReference_1374 asemeReference
highlight default link asemeReference_14 asemeReference
highlight default link asemeReference_142 asemeReference
highlight default link asemeReference_143 asemeReference
highlight default link asemeReference_146 asemeReference
highlight default link asemeReference_147 asemeReference
highlight default link asemeReference_196 asemeReference
highlight default link asemeReference_202 asemeReference
highlight default link asemeReference_205 asemeReference
highlight default link asemeReference_224 asemeReference
highlight default link asemeReference_230 asemeReference
highlight default link asemeReference_231 asemeReference
highlight default link asemeReference_234 asemeReference
highlight default link asemeReference_238 asemeReference
highlight default link asemeReference_241 asemeReference
highlight default link asemeReference_244 asemeReference
highlight default link asemeReference_268 asemeReference
highlight default link asemeReference_270 asemeReference
highlight default link asemeReference_274 asemeReference
highlight default link asemeReference_277 asemeReference
highlight default link asemeReference_297 asemeReference
highlight default link asemeReference_301 asemeReference
highlight default link asemeReference_305 asemeReference
highlight default link asemeReference_311 asemeReference
highlight default link asemeReference_313 asemeReference
highlight default link asemeReference_334 asemeReference
highlight default link asemeReference_341 asemeReference
highlight default link asemeReference_344 asemeReference
highlight default link asemeReference_347 asemeReference
highlight default link asemeReference_35 asemeReference
highlight default link asemeReference_351 asemeReference
highlight default link asemeReference_355 asemeReference
highlight default link asemeReference_358 asemeReference
highlight default link asemeReference_360 asemeReference
highlight default link asemeReference_361 asemeReference
highlight default link asemeReference_364 asemeReference
highlight default link asemeReference_395 asemeReference
highlight default link asemeReference_397 asemeReference
highlight default link asemeReference_401 asemeReference
highlight default link asemeReference_404 asemeReference
highlight default link asemeReference_41 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_424 asemeReference
highlight default link asemeReference_455 asemeReference
highlight default link asemeReference_457 asemeReference
highlight default link asemeReference_46 asemeReference
highlight default link asemeReference_461 asemeReference
highlight default link asemeReference_464 asemeReference
highlight default link asemeReference_48 asemeReference
highlight default link asemeReference_484 asemeReference
highlight default link asemeReference_509 asemeReference
highlight default link asemeReference_513 asemeReference
highlight default link asemeReference_517 asemeReference
highlight default link asemeReference_518 asemeReference
highlight default link asemeReference_52 asemeReference
highlight default link asemeReference_522 asemeReference
highlight default link asemeReference_523 asemeReference
highlight default link asemeReference_525 asemeReference
highlight default link asemeReference_526 asemeReference
highlight default link asemeReference_530 asemeReference
highlight default link asemeReference_532 asemeReference
highlight default link asemeReference_536 asemeReference
highlight default link asemeReference_537 asemeReference
highlight default link asemeReference_539 asemeReference
highlight default link asemeReference_540 asemeReference
highlight default link asemeReference_55 asemeReference
highlight default link asemeReference_559 asemeReference
highlight default link asemeReference_599 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_623 asemeReference
highlight default link asemeReference_625 asemeReference
highlight default link asemeReference_629 asemeReference
highlight default link asemeReference_632 asemeReference
highlight default link asemeReference_652 asemeReference
highlight default link asemeReference_658 asemeReference
highlight default link asemeReference_665 asemeReference
highlight default link asemeReference_667 asemeReference
highlight default link asemeReference_671 asemeReference
highlight default link asemeReference_674 asemeReference
highlight default link asemeReference_694 asemeReference
highlight default link asemeReference_730 asemeReference
highlight default link asemeReference_734 asemeReference
highlight default link asemeReference_735 asemeReference
highlight default link asemeReference_740 asemeReference
highlight default link asemeReference_742 asemeReference
highlight default link asemeReference_746 asemeReference
highlight default link asemeReference_749 asemeReference
highlight default link asemeReference_75 asemeReference
highlight default link asemeReference_769 asemeReference
highlight default link asemeReference_773 asemeReference
highlight default link asemeReference_777 asemeReference
highlight default link asemeReference_783 asemeReference
highlight default link asemeReference_785 asemeReference
highlight default link asemeReference_806 asemeReference
highlight default link asemeReference_813 asemeReference
highlight default link asemeReference_816 asemeReference
highlight default link asemeReference_819 asemeReference
highlight default link asemeReference_823 asemeReference
highlight default link asemeReference_827 asemeReference
highlight default link asemeReference_830 asemeReference
highlight default link asemeReference_832 asemeReference
highlight default link asemeReference_833 asemeReference
highlight default link asemeReference_836 asemeReference
highlight default link asemeReference_840 asemeReference
highlight default link asemeReference_844 asemeReference
highlight default link asemeReference_883 asemeReference
highlight default link asemeReference_885 asemeReference
highlight default link asemeReference_889 asemeReference
highlight default link asemeReference_892 asemeReference
highlight default link asemeReference_912 asemeReference
highlight default link asemeReference_940 asemeReference
highlight default link asemeReference_949 asemeReference
highlight default link asemeReference_953 asemeReference
highlight default link asemeReference_968 asemeReference
highlight default link asemeReference_971 asemeReference
highlight default link asemeReference_977 asemeReference
highlight default link asemeReference_980 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1063 asemeText
highlight default link asemeText_1071 asemeText
highlight default link asemeText_1114 asemeText
highlight default link asemeText_1118 asemeText
highlight default link asemeText_1124 asemeText
highlight default link asemeText_1126 asemeText
highlight default link asemeText_1152 asemeText
highlight default link asemeText_1216 asemeText
highlight default link asemeText_1270 asemeText
highlight default link asemeText_1330 asemeText
highlight default link asemeText_1336 asemeText
highlight default link asemeText_1342 asemeText
highlight default link asemeText_1348 asemeText
highlight default link asemeText_1354 asemeText
highlight default link asemeText_1356 asemeText
highlight default link asemeText_1359 asemeText
highlight default link asemeText_1365 asemeText
highlight default link asemeText_1367 asemeText
highlight default link asemeText_1370 asemeText
highlight default link asemeText_1371 asemeText
highlight default link asemeText_155 asemeText
highlight default link asemeText_16 asemeText
highlight default link asemeText_166 asemeText
highlight default link asemeText_180 asemeText
highlight default link asemeText_208 asemeText
highlight default link asemeText_247 asemeText
highlight default link asemeText_263 asemeText
highlight default link asemeText_278 asemeText
highlight default link asemeText_315 asemeText
highlight default link asemeText_38 asemeText
highlight default link asemeText_39 asemeText
highlight default link asemeText_405 asemeText
highlight default link asemeText_465 asemeText
highlight default link asemeText_556 asemeText
highlight default link asemeText_56 asemeText
highlight default link asemeText_570 asemeText
highlight default link asemeText_633 asemeText
highlight default link asemeText_656 asemeText
highlight default link asemeText_675 asemeText
highlight default link asemeText_750 asemeText
highlight default link asemeText_787 asemeText
highlight default link asemeText_847 asemeText
highlight default link asemeText_848 asemeText
highlight default link asemeText_851 asemeText
highlight default link asemeText_893 asemeText
highlight default link asemeText_937 asemeText
highlight default link asemeTruth_1154 asemeTruth
highlight default link asemeTruth_1218 asemeTruth
highlight default link asemeTruth_1272 asemeTruth
highlight default link asemeTruth_18 asemeTruth
highlight default link asemeTruth_280 asemeTruth
highlight default link asemeTruth_317 asemeTruth
highlight default link asemeTruth_407 asemeTruth
highlight default link asemeTruth_467 asemeTruth
highlight default link asemeTruth_58 asemeTruth
highlight default link asemeTruth_635 asemeTruth
highlight default link asemeTruth_677 asemeTruth
highlight default link asemeTruth_752 asemeTruth
highlight default link asemeTruth_789 asemeTruth
highlight default link asemeTruth_895 asemeTruth
highlight default link asemeType_1009 asemeType
highlight default link asemeType_103 asemeType
highlight default link asemeType_108 asemeType
highlight default link asemeType_114 asemeType
highlight default link asemeType_1181 asemeType
highlight default link asemeType_1197 asemeType
highlight default link asemeType_161 asemeType
highlight default link asemeType_171 asemeType
highlight default link asemeType_177 asemeType
highlight default link asemeType_187 asemeType
highlight default link asemeType_370 asemeType
highlight default link asemeType_386 asemeType
highlight default link asemeType_433 asemeType
highlight default link asemeType_450 asemeType
highlight default link asemeType_489 asemeType
highlight default link asemeType_495 asemeType
highlight default link asemeType_497 asemeType
highlight default link asemeType_549 asemeType
highlight default link asemeType_858 asemeType
highlight default link asemeType_874 asemeType
highlight default link asemeType_930 asemeType
highlight default link asemeType_987 asemeType
highlight default link asemeType_995 asemeType
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
