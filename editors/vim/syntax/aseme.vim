" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1332 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1331 /\v\w+/
syntax match asemeNumber_1330 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1329 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1328 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1333 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1328,asemeText_1329,asemeNumber_1330,asemeReference_1331,asemeReference_1332,asemePunctuation_1333,asemeComment
syntax match asemeReference_37 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_36 /\v\w+/ contained
syntax match asemeNumber_35 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_34 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_33 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_38 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_12,asemeDeclaration_73,asemeDeclaration_85,asemeDeclaration_111,asemeDeclaration_145,asemeDeclaration_186,asemeDeclaration_212,asemeDeclaration_245,asemeDeclaration_699,asemeDeclaration_1071,asemeDeclaration_1074,asemeDeclaration_1217,asemeDeclaration_1286,asemeDeclaration_1315,asemeDeclaration_1326,asemeText_1328,asemeText_1329,asemeNumber_1330,asemeReference_1331,asemeReference_1332,asemePunctuation_1333,asemeComment
syntax match asemeDeclaration_1326 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1325,asemeComment_1327 skipwhite skipempty
syntax region asemeComment_1327 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1325,asemeComment_1327 skipwhite skipempty
syntax match asemeComment_1327 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1325,asemeComment_1327 skipwhite skipempty
syntax match asemeText_1325 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1324 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1322,asemeText_1323
syntax match asemeText_1323 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1324 skipwhite skipempty
syntax region asemeComment_1324 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1324 skipwhite skipempty
syntax match asemeComment_1324 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1324 skipwhite skipempty
syntax region asemePunctuation_1322 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_1305,asemeText_1317,asemeNumber_1318,asemeReference_1319,asemeOperator_1320,asemePunctuation_1321,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemePunctuation_1321 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1320 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1319 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1318 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1317 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1315 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_1314,asemeComment_1316 skipwhite skipempty
syntax region asemeComment_1316 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1314,asemeComment_1316 skipwhite skipempty
syntax match asemeComment_1316 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1314,asemeComment_1316 skipwhite skipempty
syntax match asemeText_1314 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1313 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_1311,asemeText_1312
syntax match asemeText_1312 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1313 skipwhite skipempty
syntax region asemeComment_1313 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1313 skipwhite skipempty
syntax match asemeComment_1313 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1313 skipwhite skipempty
syntax region asemePunctuation_1311 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_1305,asemeText_1306,asemeNumber_1307,asemeReference_1308,asemeOperator_1309,asemePunctuation_1310,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemePunctuation_1310 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1309 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1308 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1307 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1306 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1305 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_1299,asemeText_1300,asemeNumber_1301,asemeReference_1302,asemeOperator_1303,asemePunctuation_1304,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemePunctuation_1304 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1303 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1302 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1301 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1300 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1299 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_1293,asemeText_1294,asemeNumber_1295,asemeReference_1296,asemeOperator_1297,asemePunctuation_1298,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemePunctuation_1298 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1297 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1296 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1295 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1294 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1293 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_1288,asemeNumber_1289,asemeReference_1290,asemeOperator_1291,asemePunctuation_1292,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemePunctuation_1292 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1291 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1290 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1289 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1288 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1286 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_1285,asemeComment_1287 skipwhite skipempty
syntax region asemeComment_1287 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1285,asemeComment_1287 skipwhite skipempty
syntax match asemeComment_1287 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1285,asemeComment_1287 skipwhite skipempty
syntax match asemeBlock_1285 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1284 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_1282,asemeBlock_1283
syntax match asemeBlock_1283 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1284 skipwhite skipempty
syntax region asemeComment_1284 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1284 skipwhite skipempty
syntax match asemeComment_1284 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1284 skipwhite skipempty
syntax region asemePunctuation_1282 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_1281,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeName_1281 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_1253,asemePunctuation_1263,asemePunctuation_1268,asemePunctuation_1274,asemePunctuation_1277,asemePunctuation_1279,asemeOperator_1280
syntax match asemeOperator_1280 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemePunctuation_1279 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax match asemePunctuation_1277 /\v\:/ contained nextgroup=asemeReference_1276,asemeComment_1278 skipwhite skipempty
syntax region asemeComment_1278 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1276,asemeComment_1278 skipwhite skipempty
syntax match asemeComment_1278 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1276,asemeComment_1278 skipwhite skipempty
syntax match asemeReference_1276 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax match asemePunctuation_1274 /\v\,/ contained nextgroup=asemeName_1271,asemeName_1273,asemeComment_1275 skipwhite skipempty
syntax region asemeComment_1275 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1271,asemeName_1273,asemeComment_1275 skipwhite skipempty
syntax match asemeComment_1275 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1271,asemeName_1273,asemeComment_1275 skipwhite skipempty
syntax match asemeName_1273 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax match asemeName_1271 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1270,asemeComment_1272 skipwhite skipempty
syntax region asemeComment_1272 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1270,asemeComment_1272 skipwhite skipempty
syntax match asemeComment_1272 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1270,asemeComment_1272 skipwhite skipempty
syntax match asemeOperator_1270 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemePunctuation_1268 /\v\.\./ contained nextgroup=asemeNumber_1266,asemeComment_1269 skipwhite skipempty
syntax region asemeComment_1269 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1266,asemeComment_1269 skipwhite skipempty
syntax match asemeComment_1269 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1266,asemeComment_1269 skipwhite skipempty
syntax match asemeNumber_1266 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1265,asemeComment_1267 skipwhite skipempty
syntax region asemeComment_1267 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1265,asemeComment_1267 skipwhite skipempty
syntax match asemeComment_1267 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1265,asemeComment_1267 skipwhite skipempty
syntax match asemePunctuation_1265 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax match asemePunctuation_1263 /\v\[/ contained nextgroup=asemeNumber_1261,asemeComment_1264 skipwhite skipempty
syntax region asemeComment_1264 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1261,asemeComment_1264 skipwhite skipempty
syntax match asemeComment_1264 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1261,asemeComment_1264 skipwhite skipempty
syntax match asemeNumber_1261 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1259,asemeComment_1262 skipwhite skipempty
syntax region asemeComment_1262 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1259,asemeComment_1262 skipwhite skipempty
syntax match asemeComment_1262 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1259,asemeComment_1262 skipwhite skipempty
syntax match asemePunctuation_1259 /\v\.\./ contained nextgroup=asemeNumber_1257,asemeComment_1260 skipwhite skipempty
syntax region asemeComment_1260 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1257,asemeComment_1260 skipwhite skipempty
syntax match asemeComment_1260 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1257,asemeComment_1260 skipwhite skipempty
syntax match asemeNumber_1257 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1255,asemeComment_1258 skipwhite skipempty
syntax region asemeComment_1258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1255,asemeComment_1258 skipwhite skipempty
syntax match asemeComment_1258 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1255,asemeComment_1258 skipwhite skipempty
syntax match asemePunctuation_1255 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax region asemeComment_1256 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax match asemeComment_1256 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1256 skipwhite skipempty
syntax match asemeClause_1253 /\vwith%(<|>)/ contained nextgroup=asemeName_1251,asemeComment_1254 skipwhite skipempty
syntax region asemeComment_1254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1251,asemeComment_1254 skipwhite skipempty
syntax match asemeComment_1254 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1251,asemeComment_1254 skipwhite skipempty
syntax match asemeName_1251 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1250,asemeComment_1252 skipwhite skipempty
syntax region asemeComment_1252 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1250,asemeComment_1252 skipwhite skipempty
syntax match asemeComment_1252 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1250,asemeComment_1252 skipwhite skipempty
syntax match asemeOperator_1250 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeDeclaration_1217 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_1216,asemeComment_1218 skipwhite skipempty
syntax region asemeComment_1218 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1216,asemeComment_1218 skipwhite skipempty
syntax match asemeComment_1218 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1216,asemeComment_1218 skipwhite skipempty
syntax match asemeBlock_1216 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1215 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_1213,asemeBlock_1214
syntax match asemeBlock_1214 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1215 skipwhite skipempty
syntax region asemeComment_1215 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1215 skipwhite skipempty
syntax match asemeComment_1215 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1215 skipwhite skipempty
syntax region asemePunctuation_1213 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_1098,asemeNumber_1105,asemeDeclaration_1141,asemeDeclaration_1202,asemeDeclaration_1207,asemeDeclaration_1209,asemeDeclaration_1211,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_1211 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1212 skipwhite skipempty
syntax region asemeComment_1212 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1212 skipwhite skipempty
syntax match asemeComment_1212 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1212 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_1035
syntax match asemeDeclaration_1209 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1210 skipwhite skipempty
syntax region asemeComment_1210 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1210 skipwhite skipempty
syntax match asemeComment_1210 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1210 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_982
syntax match asemeDeclaration_1207 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_1205,asemeComment_1208 skipwhite skipempty
syntax region asemeComment_1208 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1205,asemeComment_1208 skipwhite skipempty
syntax match asemeComment_1208 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1205,asemeComment_1208 skipwhite skipempty
syntax match asemeName_1205 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1204,asemeComment_1206 skipwhite skipempty
syntax region asemeComment_1206 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1204,asemeComment_1206 skipwhite skipempty
syntax match asemeComment_1206 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1204,asemeComment_1206 skipwhite skipempty
syntax match asemeOperator_1204 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeDeclaration_1202 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_1201,asemeComment_1203 skipwhite skipempty
syntax region asemeComment_1203 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1201,asemeComment_1203 skipwhite skipempty
syntax match asemeComment_1203 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1201,asemeComment_1203 skipwhite skipempty
syntax match asemeName_1201 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemeClause_1146,asemeClause_1148,asemePunctuation_1152,asemeNumber_1157,asemePunctuation_1162,asemePunctuation_1165,asemePunctuation_1167,asemeOperator_1199,asemeName_1200
syntax match asemeName_1200 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeOperator_1199 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemePunctuation_1167 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemePunctuation_1165 /\v\.\./ contained nextgroup=asemeNumber_1164,asemeComment_1166 skipwhite skipempty
syntax region asemeComment_1166 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1164,asemeComment_1166 skipwhite skipempty
syntax match asemeComment_1166 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1164,asemeComment_1166 skipwhite skipempty
syntax match asemeNumber_1164 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemePunctuation_1162 /\v\:/ contained nextgroup=asemeClause_1159,asemeBuiltIn_1160,asemeType_1161,asemeComment_1163 skipwhite skipempty
syntax region asemeComment_1163 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1159,asemeBuiltIn_1160,asemeType_1161,asemeComment_1163 skipwhite skipempty
syntax match asemeComment_1163 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1159,asemeBuiltIn_1160,asemeType_1161,asemeComment_1163 skipwhite skipempty
syntax match asemeType_1161 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeBuiltIn_1160 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeClause_1159 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeNumber_1157 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1155,asemeComment_1158 skipwhite skipempty
syntax region asemeComment_1158 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1155,asemeComment_1158 skipwhite skipempty
syntax match asemeComment_1158 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1155,asemeComment_1158 skipwhite skipempty
syntax match asemePunctuation_1155 /\v\.\./ contained nextgroup=asemeNumber_1154,asemeComment_1156 skipwhite skipempty
syntax region asemeComment_1156 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1154,asemeComment_1156 skipwhite skipempty
syntax match asemeComment_1156 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1154,asemeComment_1156 skipwhite skipempty
syntax match asemeNumber_1154 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemePunctuation_1152 /\v\[/ contained nextgroup=asemeNumber_1150,asemeComment_1153 skipwhite skipempty
syntax region asemeComment_1153 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1150,asemeComment_1153 skipwhite skipempty
syntax match asemeComment_1153 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1150,asemeComment_1153 skipwhite skipempty
syntax match asemeNumber_1150 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1149,asemeComment_1151 skipwhite skipempty
syntax region asemeComment_1151 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1149,asemeComment_1151 skipwhite skipempty
syntax match asemeComment_1151 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1149,asemeComment_1151 skipwhite skipempty
syntax match asemePunctuation_1149 /\v\]/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeClause_1148 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeClause_1146 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_1143,asemeType_1145,asemeComment_1147 skipwhite skipempty
syntax region asemeComment_1147 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1143,asemeType_1145,asemeComment_1147 skipwhite skipempty
syntax match asemeComment_1147 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1143,asemeType_1145,asemeComment_1147 skipwhite skipempty
syntax match asemeType_1145 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeBuiltIn_1143 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax region asemeComment_1144 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeComment_1144 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1144 skipwhite skipempty
syntax match asemeDeclaration_1141 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_1139,asemeComment_1142 skipwhite skipempty
syntax region asemeComment_1142 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1139,asemeComment_1142 skipwhite skipempty
syntax match asemeComment_1142 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1139,asemeComment_1142 skipwhite skipempty
syntax match asemeNumber_1139 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1138,asemeComment_1140 skipwhite skipempty
syntax region asemeComment_1140 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1138,asemeComment_1140 skipwhite skipempty
syntax match asemeComment_1140 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1138,asemeComment_1140 skipwhite skipempty
syntax match asemePunctuation_1138 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeNumber_1105 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_1103,asemeComment_1106 skipwhite skipempty
syntax region asemeComment_1106 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1103,asemeComment_1106 skipwhite skipempty
syntax match asemeComment_1106 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1103,asemeComment_1106 skipwhite skipempty
syntax match asemeOperator_1103 /\v\-\>/ contained nextgroup=asemeNumber_1101,asemeComment_1104 skipwhite skipempty
syntax region asemeComment_1104 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1101,asemeComment_1104 skipwhite skipempty
syntax match asemeComment_1104 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1101,asemeComment_1104 skipwhite skipempty
syntax match asemeNumber_1101 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1100,asemeComment_1102 skipwhite skipempty
syntax region asemeComment_1102 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1100,asemeComment_1102 skipwhite skipempty
syntax match asemeComment_1102 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1100,asemeComment_1102 skipwhite skipempty
syntax match asemePunctuation_1100 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeDeclaration_1098 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_1096,asemeComment_1099 skipwhite skipempty
syntax region asemeComment_1099 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1096,asemeComment_1099 skipwhite skipempty
syntax match asemeComment_1099 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1096,asemeComment_1099 skipwhite skipempty
syntax match asemeNumber_1096 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1094,asemeComment_1097 skipwhite skipempty
syntax region asemeComment_1097 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1094,asemeComment_1097 skipwhite skipempty
syntax match asemeComment_1097 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1094,asemeComment_1097 skipwhite skipempty
syntax match asemeChoice_1094 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1092,asemeText_1093,@asemeChartNodeInBodyOfStatechart,asemeComment_1095 skipwhite skipempty
syntax region asemeComment_1095 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1092,asemeText_1093,@asemeChartNodeInBodyOfStatechart,asemeComment_1095 skipwhite skipempty
syntax match asemeComment_1095 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1092,asemeText_1093,@asemeChartNodeInBodyOfStatechart,asemeComment_1095 skipwhite skipempty
syntax match asemeText_1093 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeName_1092 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_1078,asemeChoice_1082,asemeNumber_1088,asemeName_1090,asemeText_1091
syntax match asemeText_1091 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeName_1090 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeNumber_1088 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1086,asemeComment_1089 skipwhite skipempty
syntax region asemeComment_1089 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1086,asemeComment_1089 skipwhite skipempty
syntax match asemeComment_1089 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1086,asemeComment_1089 skipwhite skipempty
syntax match asemeChoice_1086 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1084,asemeText_1085,@asemeChartNodeInBodyOfStatechart,asemeComment_1087 skipwhite skipempty
syntax region asemeComment_1087 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1084,asemeText_1085,@asemeChartNodeInBodyOfStatechart,asemeComment_1087 skipwhite skipempty
syntax match asemeComment_1087 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1084,asemeText_1085,@asemeChartNodeInBodyOfStatechart,asemeComment_1087 skipwhite skipempty
syntax match asemeText_1085 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeName_1084 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeChoice_1082 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1080,asemeText_1081,@asemeChartNodeInBodyOfStatechart,asemeComment_1083 skipwhite skipempty
syntax region asemeComment_1083 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1080,asemeText_1081,@asemeChartNodeInBodyOfStatechart,asemeComment_1083 skipwhite skipempty
syntax match asemeComment_1083 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1080,asemeText_1081,@asemeChartNodeInBodyOfStatechart,asemeComment_1083 skipwhite skipempty
syntax match asemeText_1081 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeName_1080 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeClause_1078 /\vactivity%(<|>)/ contained nextgroup=asemeReference_1076,asemeComment_1079 skipwhite skipempty
syntax region asemeComment_1079 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1076,asemeComment_1079 skipwhite skipempty
syntax match asemeComment_1079 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1076,asemeComment_1079 skipwhite skipempty
syntax match asemeReference_1076 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax region asemeComment_1077 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeComment_1077 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1077 skipwhite skipempty
syntax match asemeDeclaration_1074 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_1073,asemeComment_1075 skipwhite skipempty
syntax region asemeComment_1075 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1073,asemeComment_1075 skipwhite skipempty
syntax match asemeComment_1075 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1073,asemeComment_1075 skipwhite skipempty
syntax match asemeBlock_1073 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_702 skipwhite skipempty
syntax match asemeDeclaration_1071 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_1069,asemeComment_1072 skipwhite skipempty
syntax region asemeComment_1072 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1069,asemeComment_1072 skipwhite skipempty
syntax match asemeComment_1072 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1069,asemeComment_1072 skipwhite skipempty
syntax match asemeClause_1069 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_1068,asemeComment_1070 skipwhite skipempty
syntax region asemeComment_1070 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1068,asemeComment_1070 skipwhite skipempty
syntax match asemeComment_1070 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1068,asemeComment_1070 skipwhite skipempty
syntax match asemeBlock_1068 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_702 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_703,asemePunctuation_1066,asemeBlock_1067
syntax match asemeBlock_1067 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_702 skipwhite skipempty
syntax region asemePunctuation_1066 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_711,asemeDeclaration_808,asemeDeclaration_824,asemeDeclaration_885,asemeDeclaration_890,asemeDeclaration_914,asemeDeclaration_983,asemeDeclaration_1036,asemeDeclaration_1045,asemeDeclaration_1064,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_1064 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_1062,asemeComment_1065 skipwhite skipempty
syntax region asemeComment_1065 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1062,asemeComment_1065 skipwhite skipempty
syntax match asemeComment_1065 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1062,asemeComment_1065 skipwhite skipempty
syntax match asemeBlock_1062 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1059,asemeOperator_1061,@asemeControlInBodyOfSrm,asemeComment_1063 skipwhite skipempty
syntax region asemeComment_1063 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1059,asemeOperator_1061,@asemeControlInBodyOfSrm,asemeComment_1063 skipwhite skipempty
syntax match asemeComment_1063 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1059,asemeOperator_1061,@asemeControlInBodyOfSrm,asemeComment_1063 skipwhite skipempty
syntax match asemeOperator_1061 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeOperator_1059 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1058,@asemeControlInBodyOfSrm,asemeComment_1060 skipwhite skipempty
syntax region asemeComment_1060 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1058,@asemeControlInBodyOfSrm,asemeComment_1060 skipwhite skipempty
syntax match asemeComment_1060 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1058,@asemeControlInBodyOfSrm,asemeComment_1060 skipwhite skipempty
syntax match asemeOperator_1058 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemeOperator_1049,asemePunctuation_679,asemeOperator_1051,asemeBlock_1056
syntax match asemeBlock_1056 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1053,asemeOperator_1055,@asemeControlInBodyOfSrm,asemeComment_1057 skipwhite skipempty
syntax region asemeComment_1057 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1053,asemeOperator_1055,@asemeControlInBodyOfSrm,asemeComment_1057 skipwhite skipempty
syntax match asemeComment_1057 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1053,asemeOperator_1055,@asemeControlInBodyOfSrm,asemeComment_1057 skipwhite skipempty
syntax match asemeOperator_1055 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeOperator_1053 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1052,@asemeControlInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax region asemeComment_1054 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1052,@asemeControlInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax match asemeComment_1054 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1052,@asemeControlInBodyOfSrm,asemeComment_1054 skipwhite skipempty
syntax match asemeOperator_1052 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeOperator_1051 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeOperator_1049 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1047,@asemeControlInBodyOfSrm,asemeComment_1050 skipwhite skipempty
syntax region asemeComment_1050 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1047,@asemeControlInBodyOfSrm,asemeComment_1050 skipwhite skipempty
syntax match asemeComment_1050 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1047,@asemeControlInBodyOfSrm,asemeComment_1050 skipwhite skipempty
syntax match asemeOperator_1047 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax region asemeComment_1048 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeComment_1048 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1048 skipwhite skipempty
syntax match asemeDeclaration_1045 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_1044,asemeComment_1046 skipwhite skipempty
syntax region asemeComment_1046 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1044,asemeComment_1046 skipwhite skipempty
syntax match asemeComment_1046 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1044,asemeComment_1046 skipwhite skipempty
syntax match asemeBlock_1044 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1043 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_1041,asemeBlock_1042
syntax match asemeBlock_1042 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1043 skipwhite skipempty
syntax region asemeComment_1043 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1043 skipwhite skipempty
syntax match asemeComment_1043 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1043 skipwhite skipempty
syntax region asemePunctuation_1041 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_1039,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_1039 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_1038,asemeComment_1040 skipwhite skipempty
syntax region asemeComment_1040 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1038,asemeComment_1040 skipwhite skipempty
syntax match asemeComment_1040 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1038,asemeComment_1040 skipwhite skipempty
syntax match asemeText_1038 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1036 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1037 skipwhite skipempty
syntax region asemeComment_1037 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1037 skipwhite skipempty
syntax match asemeComment_1037 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1037 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_1035
syntax region asemePunctuation_1035 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_1034,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeName_1034 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_990,asemeClause_993,asemeClause_996,asemeClause_999,asemeClause_1002,asemeClause_1005,asemeChoice_1008,asemeClause_1011,asemeClause_1014,asemeClause_1017,asemeClause_1019,asemeChoice_1020,asemeChoice_1021,asemePunctuation_1028,asemeOperator_1031,asemeReference_1033
syntax match asemeReference_1033 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeOperator_1031 /\v\=%(\=)@!/ contained nextgroup=asemeText_1030,asemeComment_1032 skipwhite skipempty
syntax region asemeComment_1032 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1030,asemeComment_1032 skipwhite skipempty
syntax match asemeComment_1032 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1030,asemeComment_1032 skipwhite skipempty
syntax match asemeText_1030 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemePunctuation_1028 /\v\,/ contained nextgroup=asemeChoice_1023,asemeReference_1025,asemeReference_1026,asemeReference_1027,asemeComment_1029 skipwhite skipempty
syntax region asemeComment_1029 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1023,asemeReference_1025,asemeReference_1026,asemeReference_1027,asemeComment_1029 skipwhite skipempty
syntax match asemeComment_1029 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1023,asemeReference_1025,asemeReference_1026,asemeReference_1027,asemeComment_1029 skipwhite skipempty
syntax match asemeReference_1027 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeReference_1026 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeReference_1025 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeChoice_1023 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1022,asemeComment_1024 skipwhite skipempty
syntax region asemeComment_1024 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1022,asemeComment_1024 skipwhite skipempty
syntax match asemeComment_1024 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1022,asemeComment_1024 skipwhite skipempty
syntax match asemeReference_1022 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeChoice_1021 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeChoice_1020 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_1019 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_1017 /\vends%(<|>)/ contained nextgroup=asemeReference_1016,asemeComment_1018 skipwhite skipempty
syntax region asemeComment_1018 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1016,asemeComment_1018 skipwhite skipempty
syntax match asemeComment_1018 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1016,asemeComment_1018 skipwhite skipempty
syntax match asemeReference_1016 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_1014 /\vwrites%(<|>)/ contained nextgroup=asemeReference_1013,asemeComment_1015 skipwhite skipempty
syntax region asemeComment_1015 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1013,asemeComment_1015 skipwhite skipempty
syntax match asemeComment_1015 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1013,asemeComment_1015 skipwhite skipempty
syntax match asemeReference_1013 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_1011 /\vfor%(<|>)/ contained nextgroup=asemeNumber_1010,asemeComment_1012 skipwhite skipempty
syntax region asemeComment_1012 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1010,asemeComment_1012 skipwhite skipempty
syntax match asemeComment_1012 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1010,asemeComment_1012 skipwhite skipempty
syntax match asemeNumber_1010 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeChoice_1008 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_1007,asemeComment_1009 skipwhite skipempty
syntax region asemeComment_1009 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1007,asemeComment_1009 skipwhite skipempty
syntax match asemeComment_1009 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1007,asemeComment_1009 skipwhite skipempty
syntax match asemeReference_1007 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_1005 /\vuses%(<|>)/ contained nextgroup=asemeReference_1004,asemeComment_1006 skipwhite skipempty
syntax region asemeComment_1006 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1004,asemeComment_1006 skipwhite skipempty
syntax match asemeComment_1006 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1004,asemeComment_1006 skipwhite skipempty
syntax match asemeReference_1004 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_1002 /\vas%(<|>)/ contained nextgroup=asemeChoice_1001,asemeComment_1003 skipwhite skipempty
syntax region asemeComment_1003 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1001,asemeComment_1003 skipwhite skipempty
syntax match asemeComment_1003 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1001,asemeComment_1003 skipwhite skipempty
syntax match asemeChoice_1001 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_999 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_998,asemeComment_1000 skipwhite skipempty
syntax region asemeComment_1000 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_998,asemeComment_1000 skipwhite skipempty
syntax match asemeComment_1000 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_998,asemeComment_1000 skipwhite skipempty
syntax match asemeNumber_998 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_996 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_995,asemeComment_997 skipwhite skipempty
syntax region asemeComment_997 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_995,asemeComment_997 skipwhite skipempty
syntax match asemeComment_997 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_995,asemeComment_997 skipwhite skipempty
syntax match asemeNumber_995 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_993 /\vevery%(<|>)/ contained nextgroup=asemeNumber_992,asemeComment_994 skipwhite skipempty
syntax region asemeComment_994 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_992,asemeComment_994 skipwhite skipempty
syntax match asemeComment_994 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_992,asemeComment_994 skipwhite skipempty
syntax match asemeNumber_992 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeClause_990 /\vreads%(<|>)/ contained nextgroup=asemeChoice_987,asemeReference_989,asemeComment_991 skipwhite skipempty
syntax region asemeComment_991 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_987,asemeReference_989,asemeComment_991 skipwhite skipempty
syntax match asemeComment_991 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_987,asemeReference_989,asemeComment_991 skipwhite skipempty
syntax match asemeReference_989 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeChoice_987 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_985,asemeComment_988 skipwhite skipempty
syntax region asemeComment_988 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_985,asemeComment_988 skipwhite skipempty
syntax match asemeComment_988 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_985,asemeComment_988 skipwhite skipempty
syntax match asemeReference_985 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax region asemeComment_986 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeComment_986 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_986 skipwhite skipempty
syntax match asemeDeclaration_983 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_984 skipwhite skipempty
syntax region asemeComment_984 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_984 skipwhite skipempty
syntax match asemeComment_984 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_984 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_982
syntax region asemePunctuation_982 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_981,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeName_981 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_921,asemeClause_924,asemeClause_927,asemeClause_930,asemeClause_933,asemeClause_936,asemeChoice_939,asemeClause_942,asemeClause_945,asemeClause_948,asemeClause_950,asemeChoice_951,asemeChoice_952,asemePunctuation_959,asemePunctuation_973,asemePunctuation_977,asemePunctuation_979,asemeReference_980
syntax match asemeReference_980 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemePunctuation_979 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemePunctuation_977 /\v\:/ contained nextgroup=asemeBuiltIn_975,asemeType_976,asemeComment_978 skipwhite skipempty
syntax region asemeComment_978 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_975,asemeType_976,asemeComment_978 skipwhite skipempty
syntax match asemeComment_978 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_975,asemeType_976,asemeComment_978 skipwhite skipempty
syntax match asemeType_976 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeBuiltIn_975 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemePunctuation_973 /\v\,/ contained nextgroup=asemeName_965,asemeChoice_968,asemeReference_970,asemeReference_971,asemeReference_972,asemeComment_974 skipwhite skipempty
syntax region asemeComment_974 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_965,asemeChoice_968,asemeReference_970,asemeReference_971,asemeReference_972,asemeComment_974 skipwhite skipempty
syntax match asemeComment_974 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_965,asemeChoice_968,asemeReference_970,asemeReference_971,asemeReference_972,asemeComment_974 skipwhite skipempty
syntax match asemeReference_972 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeReference_971 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeReference_970 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeChoice_968 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_967,asemeComment_969 skipwhite skipempty
syntax region asemeComment_969 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_967,asemeComment_969 skipwhite skipempty
syntax match asemeComment_969 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_967,asemeComment_969 skipwhite skipempty
syntax match asemeReference_967 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeName_965 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_963,asemeComment_966 skipwhite skipempty
syntax region asemeComment_966 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_963,asemeComment_966 skipwhite skipempty
syntax match asemeComment_966 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_963,asemeComment_966 skipwhite skipempty
syntax match asemePunctuation_963 /\v\:/ contained nextgroup=asemeBuiltIn_961,asemeType_962,asemeComment_964 skipwhite skipempty
syntax region asemeComment_964 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_961,asemeType_962,asemeComment_964 skipwhite skipempty
syntax match asemeComment_964 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_961,asemeType_962,asemeComment_964 skipwhite skipempty
syntax match asemeType_962 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeBuiltIn_961 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemePunctuation_959 /\v\(/ contained nextgroup=asemeName_957,asemeComment_960 skipwhite skipempty
syntax region asemeComment_960 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_957,asemeComment_960 skipwhite skipempty
syntax match asemeComment_960 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_957,asemeComment_960 skipwhite skipempty
syntax match asemeName_957 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_955,asemeComment_958 skipwhite skipempty
syntax region asemeComment_958 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_955,asemeComment_958 skipwhite skipempty
syntax match asemeComment_958 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_955,asemeComment_958 skipwhite skipempty
syntax match asemePunctuation_955 /\v\:/ contained nextgroup=asemeBuiltIn_953,asemeType_954,asemeComment_956 skipwhite skipempty
syntax region asemeComment_956 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_953,asemeType_954,asemeComment_956 skipwhite skipempty
syntax match asemeComment_956 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_953,asemeType_954,asemeComment_956 skipwhite skipempty
syntax match asemeType_954 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeBuiltIn_953 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeChoice_952 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeChoice_951 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_950 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_948 /\vends%(<|>)/ contained nextgroup=asemeReference_947,asemeComment_949 skipwhite skipempty
syntax region asemeComment_949 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_947,asemeComment_949 skipwhite skipempty
syntax match asemeComment_949 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_947,asemeComment_949 skipwhite skipempty
syntax match asemeReference_947 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_945 /\vwrites%(<|>)/ contained nextgroup=asemeReference_944,asemeComment_946 skipwhite skipempty
syntax region asemeComment_946 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_944,asemeComment_946 skipwhite skipempty
syntax match asemeComment_946 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_944,asemeComment_946 skipwhite skipempty
syntax match asemeReference_944 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_942 /\vfor%(<|>)/ contained nextgroup=asemeNumber_941,asemeComment_943 skipwhite skipempty
syntax region asemeComment_943 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_941,asemeComment_943 skipwhite skipempty
syntax match asemeComment_943 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_941,asemeComment_943 skipwhite skipempty
syntax match asemeNumber_941 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeChoice_939 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_938,asemeComment_940 skipwhite skipempty
syntax region asemeComment_940 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_938,asemeComment_940 skipwhite skipempty
syntax match asemeComment_940 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_938,asemeComment_940 skipwhite skipempty
syntax match asemeReference_938 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_936 /\vuses%(<|>)/ contained nextgroup=asemeReference_935,asemeComment_937 skipwhite skipempty
syntax region asemeComment_937 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_935,asemeComment_937 skipwhite skipempty
syntax match asemeComment_937 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_935,asemeComment_937 skipwhite skipempty
syntax match asemeReference_935 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_933 /\vas%(<|>)/ contained nextgroup=asemeChoice_932,asemeComment_934 skipwhite skipempty
syntax region asemeComment_934 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_932,asemeComment_934 skipwhite skipempty
syntax match asemeComment_934 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_932,asemeComment_934 skipwhite skipempty
syntax match asemeChoice_932 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_930 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_929,asemeComment_931 skipwhite skipempty
syntax region asemeComment_931 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_929,asemeComment_931 skipwhite skipempty
syntax match asemeComment_931 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_929,asemeComment_931 skipwhite skipempty
syntax match asemeNumber_929 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_927 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_926,asemeComment_928 skipwhite skipempty
syntax region asemeComment_928 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_926,asemeComment_928 skipwhite skipempty
syntax match asemeComment_928 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_926,asemeComment_928 skipwhite skipempty
syntax match asemeNumber_926 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_924 /\vevery%(<|>)/ contained nextgroup=asemeNumber_923,asemeComment_925 skipwhite skipempty
syntax region asemeComment_925 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_923,asemeComment_925 skipwhite skipempty
syntax match asemeComment_925 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_923,asemeComment_925 skipwhite skipempty
syntax match asemeNumber_923 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeClause_921 /\vreads%(<|>)/ contained nextgroup=asemeChoice_918,asemeReference_920,asemeComment_922 skipwhite skipempty
syntax region asemeComment_922 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_918,asemeReference_920,asemeComment_922 skipwhite skipempty
syntax match asemeComment_922 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_918,asemeReference_920,asemeComment_922 skipwhite skipempty
syntax match asemeReference_920 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeChoice_918 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_916,asemeComment_919 skipwhite skipempty
syntax region asemeComment_919 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_916,asemeComment_919 skipwhite skipempty
syntax match asemeComment_919 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_916,asemeComment_919 skipwhite skipempty
syntax match asemeReference_916 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax region asemeComment_917 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeComment_917 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_917 skipwhite skipempty
syntax match asemeDeclaration_914 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_915 skipwhite skipempty
syntax region asemeComment_915 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_915 skipwhite skipempty
syntax match asemeComment_915 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_915 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_913
syntax region asemePunctuation_913 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_912,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeName_912 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_894,asemePunctuation_898,asemePunctuation_901,asemePunctuation_903,asemeOperator_911
syntax match asemeOperator_911 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemePunctuation_903 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax match asemePunctuation_901 /\v\,/ contained nextgroup=asemeName_900,asemeComment_902 skipwhite skipempty
syntax region asemeComment_902 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_900,asemeComment_902 skipwhite skipempty
syntax match asemeComment_902 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_900,asemeComment_902 skipwhite skipempty
syntax match asemeName_900 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax match asemePunctuation_898 /\v\:/ contained nextgroup=asemeBuiltIn_896,asemeType_897,asemeComment_899 skipwhite skipempty
syntax region asemeComment_899 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_896,asemeType_897,asemeComment_899 skipwhite skipempty
syntax match asemeComment_899 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_896,asemeType_897,asemeComment_899 skipwhite skipempty
syntax match asemeType_897 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax match asemeBuiltIn_896 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax match asemePunctuation_894 /\v\(/ contained nextgroup=asemeName_892,asemeComment_895 skipwhite skipempty
syntax region asemeComment_895 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_892,asemeComment_895 skipwhite skipempty
syntax match asemeComment_895 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_892,asemeComment_895 skipwhite skipempty
syntax match asemeName_892 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax region asemeComment_893 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax match asemeComment_893 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_893 skipwhite skipempty
syntax match asemeDeclaration_890 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_888,asemeComment_891 skipwhite skipempty
syntax region asemeComment_891 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_888,asemeComment_891 skipwhite skipempty
syntax match asemeComment_891 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_888,asemeComment_891 skipwhite skipempty
syntax match asemeName_888 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_887,asemeComment_889 skipwhite skipempty
syntax region asemeComment_889 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_887,asemeComment_889 skipwhite skipempty
syntax match asemeComment_889 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_887,asemeComment_889 skipwhite skipempty
syntax match asemeOperator_887 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeDeclaration_885 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_884,asemeComment_886 skipwhite skipempty
syntax region asemeComment_886 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_884,asemeComment_886 skipwhite skipempty
syntax match asemeComment_886 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_884,asemeComment_886 skipwhite skipempty
syntax match asemeName_884 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemeClause_829,asemeClause_831,asemePunctuation_835,asemeNumber_840,asemePunctuation_845,asemePunctuation_848,asemePunctuation_850,asemeOperator_882,asemeName_883
syntax match asemeName_883 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeOperator_882 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemePunctuation_850 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemePunctuation_848 /\v\.\./ contained nextgroup=asemeNumber_847,asemeComment_849 skipwhite skipempty
syntax region asemeComment_849 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_847,asemeComment_849 skipwhite skipempty
syntax match asemeComment_849 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_847,asemeComment_849 skipwhite skipempty
syntax match asemeNumber_847 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemePunctuation_845 /\v\:/ contained nextgroup=asemeClause_842,asemeBuiltIn_843,asemeType_844,asemeComment_846 skipwhite skipempty
syntax region asemeComment_846 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_842,asemeBuiltIn_843,asemeType_844,asemeComment_846 skipwhite skipempty
syntax match asemeComment_846 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_842,asemeBuiltIn_843,asemeType_844,asemeComment_846 skipwhite skipempty
syntax match asemeType_844 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeBuiltIn_843 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeClause_842 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeNumber_840 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_838,asemeComment_841 skipwhite skipempty
syntax region asemeComment_841 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_838,asemeComment_841 skipwhite skipempty
syntax match asemeComment_841 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_838,asemeComment_841 skipwhite skipempty
syntax match asemePunctuation_838 /\v\.\./ contained nextgroup=asemeNumber_837,asemeComment_839 skipwhite skipempty
syntax region asemeComment_839 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_837,asemeComment_839 skipwhite skipempty
syntax match asemeComment_839 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_837,asemeComment_839 skipwhite skipempty
syntax match asemeNumber_837 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemePunctuation_835 /\v\[/ contained nextgroup=asemeNumber_833,asemeComment_836 skipwhite skipempty
syntax region asemeComment_836 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_833,asemeComment_836 skipwhite skipempty
syntax match asemeComment_836 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_833,asemeComment_836 skipwhite skipempty
syntax match asemeNumber_833 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_832,asemeComment_834 skipwhite skipempty
syntax region asemeComment_834 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_832,asemeComment_834 skipwhite skipempty
syntax match asemeComment_834 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_832,asemeComment_834 skipwhite skipempty
syntax match asemePunctuation_832 /\v\]/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeClause_831 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeClause_829 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_826,asemeType_828,asemeComment_830 skipwhite skipempty
syntax region asemeComment_830 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_826,asemeType_828,asemeComment_830 skipwhite skipempty
syntax match asemeComment_830 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_826,asemeType_828,asemeComment_830 skipwhite skipempty
syntax match asemeType_828 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeBuiltIn_826 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax region asemeComment_827 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeComment_827 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_827 skipwhite skipempty
syntax match asemeDeclaration_824 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_822,asemeComment_825 skipwhite skipempty
syntax region asemeComment_825 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_822,asemeComment_825 skipwhite skipempty
syntax match asemeComment_825 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_822,asemeComment_825 skipwhite skipempty
syntax match asemeName_822 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_821,@asemeCapabilityInBodyOfSrm,asemeComment_823 skipwhite skipempty
syntax region asemeComment_823 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_821,@asemeCapabilityInBodyOfSrm,asemeComment_823 skipwhite skipempty
syntax match asemeComment_823 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_821,@asemeCapabilityInBodyOfSrm,asemeComment_823 skipwhite skipempty
syntax match asemeText_821 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_812,asemePunctuation_815,asemeText_817,asemeName_819
syntax match asemeName_819 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_818,@asemeCapabilityInBodyOfSrm,asemeComment_820 skipwhite skipempty
syntax region asemeComment_820 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_818,@asemeCapabilityInBodyOfSrm,asemeComment_820 skipwhite skipempty
syntax match asemeComment_820 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_818,@asemeCapabilityInBodyOfSrm,asemeComment_820 skipwhite skipempty
syntax match asemeText_818 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax match asemeText_817 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax match asemePunctuation_815 /\v\,/ contained nextgroup=asemeReference_814,asemeComment_816 skipwhite skipempty
syntax region asemeComment_816 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_814,asemeComment_816 skipwhite skipempty
syntax match asemeComment_816 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_814,asemeComment_816 skipwhite skipempty
syntax match asemeReference_814 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax match asemeOperator_812 /\v\=%(\=)@!/ contained nextgroup=asemeReference_810,asemeComment_813 skipwhite skipempty
syntax region asemeComment_813 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_810,asemeComment_813 skipwhite skipempty
syntax match asemeComment_813 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_810,asemeComment_813 skipwhite skipempty
syntax match asemeReference_810 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax region asemeComment_811 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax match asemeComment_811 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_811 skipwhite skipempty
syntax match asemeDeclaration_808 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_806,asemeComment_809 skipwhite skipempty
syntax region asemeComment_809 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_806,asemeComment_809 skipwhite skipempty
syntax match asemeComment_809 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_806,asemeComment_809 skipwhite skipempty
syntax match asemeReference_806 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_804,asemeComment_807 skipwhite skipempty
syntax region asemeComment_807 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_804,asemeComment_807 skipwhite skipempty
syntax match asemeComment_807 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_804,asemeComment_807 skipwhite skipempty
syntax match asemePunctuation_804 /\v\./ contained nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax region asemeComment_805 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax match asemeComment_805 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_803,asemeComment_805 skipwhite skipempty
syntax match asemeReference_803 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_747,asemeClause_751,asemeClause_780,asemeClause_782,asemePunctuation_791,asemePunctuation_794,asemeOperator_796,asemeReference_800,asemeReference_802
syntax match asemeReference_802 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeReference_800 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_798,asemeComment_801 skipwhite skipempty
syntax region asemeComment_801 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_798,asemeComment_801 skipwhite skipempty
syntax match asemeComment_801 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_798,asemeComment_801 skipwhite skipempty
syntax match asemePunctuation_798 /\v\./ contained nextgroup=asemeReference_797,asemeComment_799 skipwhite skipempty
syntax region asemeComment_799 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_797,asemeComment_799 skipwhite skipempty
syntax match asemeComment_799 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_797,asemeComment_799 skipwhite skipempty
syntax match asemeReference_797 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeOperator_796 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemePunctuation_794 /\v\./ contained nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax region asemeComment_795 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax match asemeComment_795 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax match asemeReference_793 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemePunctuation_791 /\v\,/ contained nextgroup=asemeReference_786,asemeReference_789,asemeComment_792 skipwhite skipempty
syntax region asemeComment_792 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_786,asemeReference_789,asemeComment_792 skipwhite skipempty
syntax match asemeComment_792 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_786,asemeReference_789,asemeComment_792 skipwhite skipempty
syntax match asemeReference_789 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_788,asemeComment_790 skipwhite skipempty
syntax region asemeComment_790 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_788,asemeComment_790 skipwhite skipempty
syntax match asemeComment_790 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_788,asemeComment_790 skipwhite skipempty
syntax match asemeOperator_788 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeReference_786 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_784,asemeComment_787 skipwhite skipempty
syntax region asemeComment_787 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_784,asemeComment_787 skipwhite skipempty
syntax match asemeComment_787 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_784,asemeComment_787 skipwhite skipempty
syntax match asemePunctuation_784 /\v\./ contained nextgroup=asemeReference_783,asemeComment_785 skipwhite skipempty
syntax region asemeComment_785 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_783,asemeComment_785 skipwhite skipempty
syntax match asemeComment_785 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_783,asemeComment_785 skipwhite skipempty
syntax match asemeReference_783 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeClause_782 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_780 /\vwhen%(<|>)/ contained nextgroup=asemeClause_779,asemeComment_781 skipwhite skipempty
syntax region asemeComment_781 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_779,asemeComment_781 skipwhite skipempty
syntax match asemeComment_781 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_779,asemeComment_781 skipwhite skipempty
syntax match asemeClause_779 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_751 /\vas%(<|>)/ contained nextgroup=asemeReference_749,asemeComment_752 skipwhite skipempty
syntax region asemeComment_752 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_749,asemeComment_752 skipwhite skipempty
syntax match asemeComment_752 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_749,asemeComment_752 skipwhite skipempty
syntax match asemeReference_749 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax region asemeComment_750 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeComment_750 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_750 skipwhite skipempty
syntax match asemeClause_747 /\vwith%(<|>)/ contained nextgroup=asemeReference_745,asemeComment_748 skipwhite skipempty
syntax region asemeComment_748 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_745,asemeComment_748 skipwhite skipempty
syntax match asemeComment_748 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_745,asemeComment_748 skipwhite skipempty
syntax match asemeReference_745 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_744,asemeComment_746 skipwhite skipempty
syntax region asemeComment_746 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_744,asemeComment_746 skipwhite skipempty
syntax match asemeComment_746 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_744,asemeComment_746 skipwhite skipempty
syntax match asemeOperator_744 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeDeclaration_711 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_710,asemeComment_712 skipwhite skipempty
syntax region asemeComment_712 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_710,asemeComment_712 skipwhite skipempty
syntax match asemeComment_712 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_710,asemeComment_712 skipwhite skipempty
syntax match asemeReference_710 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_706 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_707,asemeReference_709
syntax match asemeReference_709 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_706 skipwhite skipempty
syntax match asemePunctuation_707 /\v\,/ contained nextgroup=asemeReference_705,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_705,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_705,asemeComment_708 skipwhite skipempty
syntax match asemeReference_705 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_706 skipwhite skipempty
syntax region asemeComment_706 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_706 skipwhite skipempty
syntax match asemeComment_706 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_706 skipwhite skipempty
syntax match asemeClause_703 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_701,asemeComment_704 skipwhite skipempty
syntax region asemeComment_704 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_701,asemeComment_704 skipwhite skipempty
syntax match asemeComment_704 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_701,asemeComment_704 skipwhite skipempty
syntax match asemeBlock_701 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_702 skipwhite skipempty
syntax region asemeComment_702 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_702 skipwhite skipempty
syntax match asemeComment_702 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_702 skipwhite skipempty
syntax match asemeDeclaration_699 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_698,asemeComment_700 skipwhite skipempty
syntax region asemeComment_700 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_698,asemeComment_700 skipwhite skipempty
syntax match asemeComment_700 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_698,asemeComment_700 skipwhite skipempty
syntax match asemeBlock_698 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_697 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_695,asemeBlock_696
syntax match asemeBlock_696 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_697 skipwhite skipempty
syntax region asemeComment_697 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_697 skipwhite skipempty
syntax match asemeComment_697 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_697 skipwhite skipempty
syntax region asemePunctuation_695 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_549,asemeDeclaration_552,asemeDeclaration_585,asemeDeclaration_589,asemeDeclaration_693,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_693 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_691,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_691,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_691,asemeComment_694 skipwhite skipempty
syntax match asemeBlock_691 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_688,asemeOperator_690,@asemeControlInBodyOfAip,asemeComment_692 skipwhite skipempty
syntax region asemeComment_692 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_688,asemeOperator_690,@asemeControlInBodyOfAip,asemeComment_692 skipwhite skipempty
syntax match asemeComment_692 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_688,asemeOperator_690,@asemeControlInBodyOfAip,asemeComment_692 skipwhite skipempty
syntax match asemeOperator_690 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax match asemeOperator_688 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_687,@asemeControlInBodyOfAip,asemeComment_689 skipwhite skipempty
syntax region asemeComment_689 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_687,@asemeControlInBodyOfAip,asemeComment_689 skipwhite skipempty
syntax match asemeComment_689 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_687,@asemeControlInBodyOfAip,asemeComment_689 skipwhite skipempty
syntax match asemeOperator_687 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemeOperator_593,asemePunctuation_679,asemeOperator_680,asemeBlock_685
syntax match asemeBlock_685 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_682,asemeOperator_684,@asemeControlInBodyOfAip,asemeComment_686 skipwhite skipempty
syntax region asemeComment_686 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_682,asemeOperator_684,@asemeControlInBodyOfAip,asemeComment_686 skipwhite skipempty
syntax match asemeComment_686 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_682,asemeOperator_684,@asemeControlInBodyOfAip,asemeComment_686 skipwhite skipempty
syntax match asemeOperator_684 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax match asemeOperator_682 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_681,@asemeControlInBodyOfAip,asemeComment_683 skipwhite skipempty
syntax region asemeComment_683 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_681,@asemeControlInBodyOfAip,asemeComment_683 skipwhite skipempty
syntax match asemeComment_683 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_681,@asemeControlInBodyOfAip,asemeComment_683 skipwhite skipempty
syntax match asemeOperator_681 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax match asemeOperator_680 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax region asemePunctuation_679 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_640,asemeNumber_677,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeNumber_677 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_675,asemeComment_678 skipwhite skipempty
syntax region asemeComment_678 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_675,asemeComment_678 skipwhite skipempty
syntax match asemeComment_678 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_675,asemeComment_678 skipwhite skipempty
syntax match asemeOperator_675 /\v\-\>/ contained nextgroup=asemeNumber_673,asemeComment_676 skipwhite skipempty
syntax region asemeComment_676 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_673,asemeComment_676 skipwhite skipempty
syntax match asemeComment_676 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_673,asemeComment_676 skipwhite skipempty
syntax match asemeNumber_673 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_672,asemeComment_674 skipwhite skipempty
syntax region asemeComment_674 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_672,asemeComment_674 skipwhite skipempty
syntax match asemeComment_674 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_672,asemeComment_674 skipwhite skipempty
syntax match asemePunctuation_672 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeDeclaration_640 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_597,asemeOperator_600,asemePunctuation_633,asemeText_634,asemeNumber_635,asemeReference_636,asemeNumber_637,asemeOperator_638,asemePunctuation_639
syntax match asemePunctuation_639 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeOperator_638 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeNumber_637 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeReference_636 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeNumber_635 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeText_634 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemePunctuation_633 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeOperator_600 /\v\#/ contained nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax match asemeNumber_599 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeClause_597 /\vevery%(<|>)/ contained nextgroup=asemeNumber_595,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_595,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_595,asemeComment_598 skipwhite skipempty
syntax match asemeNumber_595 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax region asemeComment_596 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeComment_596 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_596 skipwhite skipempty
syntax match asemeOperator_593 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_591,@asemeControlInBodyOfAip,asemeComment_594 skipwhite skipempty
syntax region asemeComment_594 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_591,@asemeControlInBodyOfAip,asemeComment_594 skipwhite skipempty
syntax match asemeComment_594 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_591,@asemeControlInBodyOfAip,asemeComment_594 skipwhite skipempty
syntax match asemeOperator_591 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_592 skipwhite skipempty
syntax match asemeDeclaration_589 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_587,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_587,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_587,asemeComment_590 skipwhite skipempty
syntax match asemeName_587 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_586,asemeComment_588 skipwhite skipempty
syntax region asemeComment_588 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_586,asemeComment_588 skipwhite skipempty
syntax match asemeComment_588 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_586,asemeComment_588 skipwhite skipempty
syntax match asemeOperator_586 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeDeclaration_585 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_559,asemeClause_563,asemeClause_566,asemeClause_569,asemeClause_572,asemeClause_574,asemeClause_575,asemeClause_576,asemePunctuation_578,asemeOperator_581,asemePunctuation_583,asemeName_584
syntax match asemeName_584 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemePunctuation_583 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeOperator_581 /\v\@/ contained nextgroup=asemeReference_580,asemeComment_582 skipwhite skipempty
syntax region asemeComment_582 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_580,asemeComment_582 skipwhite skipempty
syntax match asemeComment_582 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_580,asemeComment_582 skipwhite skipempty
syntax match asemeReference_580 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemePunctuation_578 /\v\(/ contained nextgroup=asemeName_577,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_577,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_577,asemeComment_579 skipwhite skipempty
syntax match asemeName_577 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_576 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_575 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_574 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_572 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_571,asemeComment_573 skipwhite skipempty
syntax region asemeComment_573 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_571,asemeComment_573 skipwhite skipempty
syntax match asemeComment_573 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_571,asemeComment_573 skipwhite skipempty
syntax match asemeNumber_571 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_569 /\vleads%(<|>)/ contained nextgroup=asemeClause_568,asemeComment_570 skipwhite skipempty
syntax region asemeComment_570 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_568,asemeComment_570 skipwhite skipempty
syntax match asemeComment_570 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_568,asemeComment_570 skipwhite skipempty
syntax match asemeClause_568 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_566 /\vor%(<|>)/ contained nextgroup=asemeName_565,asemeComment_567 skipwhite skipempty
syntax region asemeComment_567 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_565,asemeComment_567 skipwhite skipempty
syntax match asemeComment_567 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_565,asemeComment_567 skipwhite skipempty
syntax match asemeName_565 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_563 /\vmost%(<|>)/ contained nextgroup=asemeChoice_561,asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax region asemeComment_564 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_561,asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax match asemeComment_564 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_561,asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax match asemeNumber_562 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeChoice_561 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeClause_559 /\vat%(<|>)/ contained nextgroup=asemeClause_557,asemeComment_560 skipwhite skipempty
syntax region asemeComment_560 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_557,asemeComment_560 skipwhite skipempty
syntax match asemeComment_560 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_557,asemeComment_560 skipwhite skipempty
syntax match asemeClause_557 /\vmost%(<|>)/ contained nextgroup=asemeChoice_554,asemeNumber_556,asemeComment_558 skipwhite skipempty
syntax region asemeComment_558 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_554,asemeNumber_556,asemeComment_558 skipwhite skipempty
syntax match asemeComment_558 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_554,asemeNumber_556,asemeComment_558 skipwhite skipempty
syntax match asemeNumber_556 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeChoice_554 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax region asemeComment_555 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeComment_555 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_555 skipwhite skipempty
syntax match asemeDeclaration_552 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_551,asemeComment_553 skipwhite skipempty
syntax region asemeComment_553 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_551,asemeComment_553 skipwhite skipempty
syntax match asemeComment_553 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_551,asemeComment_553 skipwhite skipempty
syntax match asemeText_551 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_549 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_548,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_548,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_548,asemeComment_550 skipwhite skipempty
syntax match asemeBlock_548 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_249,asemePunctuation_252,asemePunctuation_254,asemePunctuation_546,asemeBlock_547
syntax match asemeBlock_547 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax region asemePunctuation_546 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_256,asemeDeclaration_353,asemeDeclaration_414,asemeDeclaration_422,asemeDeclaration_483,asemeDeclaration_488,asemeDeclaration_509,asemeDeclaration_523,asemeName_545,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeName_545 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_527,asemePunctuation_531,asemePunctuation_534,asemePunctuation_536,asemeOperator_544
syntax match asemeOperator_544 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemePunctuation_536 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax match asemePunctuation_534 /\v\,/ contained nextgroup=asemeName_533,asemeComment_535 skipwhite skipempty
syntax region asemeComment_535 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_533,asemeComment_535 skipwhite skipempty
syntax match asemeComment_535 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_533,asemeComment_535 skipwhite skipempty
syntax match asemeName_533 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax match asemePunctuation_531 /\v\:/ contained nextgroup=asemeBuiltIn_529,asemeType_530,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_529,asemeType_530,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_529,asemeType_530,asemeComment_532 skipwhite skipempty
syntax match asemeType_530 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax match asemeBuiltIn_529 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax match asemePunctuation_527 /\v\(/ contained nextgroup=asemeName_525,asemeComment_528 skipwhite skipempty
syntax region asemeComment_528 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_525,asemeComment_528 skipwhite skipempty
syntax match asemeComment_528 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_525,asemeComment_528 skipwhite skipempty
syntax match asemeName_525 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax region asemeComment_526 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax match asemeComment_526 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_526 skipwhite skipempty
syntax match asemeDeclaration_523 /\v%(receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_521,asemeComment_524 skipwhite skipempty
syntax region asemeComment_524 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_521,asemeComment_524 skipwhite skipempty
syntax match asemeComment_524 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_521,asemeComment_524 skipwhite skipempty
syntax match asemeReference_521 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_520,asemeComment_522 skipwhite skipempty
syntax region asemeComment_522 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_520,asemeComment_522 skipwhite skipempty
syntax match asemeComment_522 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_520,asemeComment_522 skipwhite skipempty
syntax match asemeReference_520 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_515,asemeReference_518
syntax match asemeReference_518 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_517,@asemeReceivesInBodyOfParticipant,asemeComment_519 skipwhite skipempty
syntax region asemeComment_519 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_517,@asemeReceivesInBodyOfParticipant,asemeComment_519 skipwhite skipempty
syntax match asemeComment_519 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_517,@asemeReceivesInBodyOfParticipant,asemeComment_519 skipwhite skipempty
syntax match asemeReference_517 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemePunctuation_515 /\v\,/ contained nextgroup=asemeReference_513,asemeComment_516 skipwhite skipempty
syntax region asemeComment_516 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_513,asemeComment_516 skipwhite skipempty
syntax match asemeComment_516 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_513,asemeComment_516 skipwhite skipempty
syntax match asemeReference_513 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_511,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_511,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_511,asemeComment_514 skipwhite skipempty
syntax match asemeReference_511 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax region asemeComment_512 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeComment_512 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeDeclaration_509 /\v%(sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_507,asemeComment_510 skipwhite skipempty
syntax region asemeComment_510 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_507,asemeComment_510 skipwhite skipempty
syntax match asemeComment_510 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_507,asemeComment_510 skipwhite skipempty
syntax match asemeReference_507 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_506,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_506,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_506,asemeComment_508 skipwhite skipempty
syntax match asemeReference_506 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_492,asemeClause_495,asemeClause_497,asemePunctuation_501,asemeReference_504
syntax match asemeReference_504 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_503,@asemeSendsInBodyOfParticipant,asemeComment_505 skipwhite skipempty
syntax region asemeComment_505 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_503,@asemeSendsInBodyOfParticipant,asemeComment_505 skipwhite skipempty
syntax match asemeComment_505 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_503,@asemeSendsInBodyOfParticipant,asemeComment_505 skipwhite skipempty
syntax match asemeReference_503 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax match asemePunctuation_501 /\v\,/ contained nextgroup=asemeReference_499,asemeComment_502 skipwhite skipempty
syntax region asemeComment_502 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_499,asemeComment_502 skipwhite skipempty
syntax match asemeComment_502 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_499,asemeComment_502 skipwhite skipempty
syntax match asemeReference_499 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_498,asemeComment_500 skipwhite skipempty
syntax region asemeComment_500 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_498,asemeComment_500 skipwhite skipempty
syntax match asemeComment_500 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_498,asemeComment_500 skipwhite skipempty
syntax match asemeReference_498 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax match asemeClause_497 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax match asemeClause_495 /\vor%(<|>)/ contained nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax region asemeComment_496 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeComment_496 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeReference_494 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax match asemeClause_492 /\vby%(<|>)/ contained nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax match asemeReference_490 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax region asemeComment_491 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax match asemeComment_491 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_491 skipwhite skipempty
syntax match asemeDeclaration_488 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_486,asemeComment_489 skipwhite skipempty
syntax region asemeComment_489 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_486,asemeComment_489 skipwhite skipempty
syntax match asemeComment_489 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_486,asemeComment_489 skipwhite skipempty
syntax match asemeName_486 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_485,asemeComment_487 skipwhite skipempty
syntax region asemeComment_487 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_485,asemeComment_487 skipwhite skipempty
syntax match asemeComment_487 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_485,asemeComment_487 skipwhite skipempty
syntax match asemeOperator_485 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeDeclaration_483 /\v%(result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=result%(<|>)/ contained nextgroup=asemeName_481,asemeComment_484 skipwhite skipempty
syntax region asemeComment_484 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_481,asemeComment_484 skipwhite skipempty
syntax match asemeComment_484 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_481,asemeComment_484 skipwhite skipempty
syntax match asemeName_481 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_479,asemeComment_482 skipwhite skipempty
syntax region asemeComment_482 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_479,asemeComment_482 skipwhite skipempty
syntax match asemeComment_482 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_479,asemeComment_482 skipwhite skipempty
syntax match asemePunctuation_479 /\v\:/ contained nextgroup=asemeBuiltIn_477,asemeType_478,asemeComment_480 skipwhite skipempty
syntax region asemeComment_480 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_477,asemeType_478,asemeComment_480 skipwhite skipempty
syntax match asemeComment_480 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_477,asemeType_478,asemeComment_480 skipwhite skipempty
syntax match asemeType_478 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeBuiltIn_477 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax cluster asemeResultInBodyOfParticipant contains=asemeNumber_428,asemePunctuation_431,asemePunctuation_435,asemeOperator_468,asemeName_473,asemeBuiltIn_475,asemeType_476
syntax match asemeType_476 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeBuiltIn_475 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeName_473 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_471,asemeComment_474 skipwhite skipempty
syntax region asemeComment_474 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_471,asemeComment_474 skipwhite skipempty
syntax match asemeComment_474 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_471,asemeComment_474 skipwhite skipempty
syntax match asemePunctuation_471 /\v\:/ contained nextgroup=asemeBuiltIn_469,asemeType_470,asemeComment_472 skipwhite skipempty
syntax region asemeComment_472 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_469,asemeType_470,asemeComment_472 skipwhite skipempty
syntax match asemeComment_472 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_469,asemeType_470,asemeComment_472 skipwhite skipempty
syntax match asemeType_470 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeBuiltIn_469 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeOperator_468 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemePunctuation_435 /\v\:/ contained nextgroup=asemeBuiltIn_433,asemeType_434,asemeComment_436 skipwhite skipempty
syntax region asemeComment_436 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_433,asemeType_434,asemeComment_436 skipwhite skipempty
syntax match asemeComment_436 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_433,asemeType_434,asemeComment_436 skipwhite skipempty
syntax match asemeType_434 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeBuiltIn_433 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemePunctuation_431 /\v\.\./ contained nextgroup=asemeNumber_430,asemeComment_432 skipwhite skipempty
syntax region asemeComment_432 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_430,asemeComment_432 skipwhite skipempty
syntax match asemeComment_432 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_430,asemeComment_432 skipwhite skipempty
syntax match asemeNumber_430 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeNumber_428 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_426,asemeComment_429 skipwhite skipempty
syntax region asemeComment_429 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_426,asemeComment_429 skipwhite skipempty
syntax match asemeComment_429 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_426,asemeComment_429 skipwhite skipempty
syntax match asemePunctuation_426 /\v\.\./ contained nextgroup=asemeNumber_424,asemeComment_427 skipwhite skipempty
syntax region asemeComment_427 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_424,asemeComment_427 skipwhite skipempty
syntax match asemeComment_427 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_424,asemeComment_427 skipwhite skipempty
syntax match asemeNumber_424 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax region asemeComment_425 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeComment_425 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_425 skipwhite skipempty
syntax match asemeDeclaration_422 /\v%(given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=given%(<|>)/ contained nextgroup=asemeName_420,asemeComment_423 skipwhite skipempty
syntax region asemeComment_423 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_420,asemeComment_423 skipwhite skipempty
syntax match asemeComment_423 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_420,asemeComment_423 skipwhite skipempty
syntax match asemeName_420 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_418,asemeComment_421 skipwhite skipempty
syntax region asemeComment_421 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_418,asemeComment_421 skipwhite skipempty
syntax match asemeComment_421 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_418,asemeComment_421 skipwhite skipempty
syntax match asemePunctuation_418 /\v\:/ contained nextgroup=asemeBuiltIn_416,asemeType_417,asemeComment_419 skipwhite skipempty
syntax region asemeComment_419 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_416,asemeType_417,asemeComment_419 skipwhite skipempty
syntax match asemeComment_419 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_416,asemeType_417,asemeComment_419 skipwhite skipempty
syntax match asemeType_417 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained
syntax match asemeBuiltIn_416 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained
syntax match asemeDeclaration_414 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_413,asemeComment_415 skipwhite skipempty
syntax region asemeComment_415 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_413,asemeComment_415 skipwhite skipempty
syntax match asemeComment_415 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_413,asemeComment_415 skipwhite skipempty
syntax match asemeName_413 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemeClause_358,asemeClause_360,asemePunctuation_364,asemeNumber_369,asemePunctuation_374,asemePunctuation_377,asemePunctuation_379,asemeOperator_411,asemeName_412
syntax match asemeName_412 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeOperator_411 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemePunctuation_379 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemePunctuation_377 /\v\.\./ contained nextgroup=asemeNumber_376,asemeComment_378 skipwhite skipempty
syntax region asemeComment_378 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_376,asemeComment_378 skipwhite skipempty
syntax match asemeComment_378 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_376,asemeComment_378 skipwhite skipempty
syntax match asemeNumber_376 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemePunctuation_374 /\v\:/ contained nextgroup=asemeClause_371,asemeBuiltIn_372,asemeType_373,asemeComment_375 skipwhite skipempty
syntax region asemeComment_375 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_371,asemeBuiltIn_372,asemeType_373,asemeComment_375 skipwhite skipempty
syntax match asemeComment_375 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_371,asemeBuiltIn_372,asemeType_373,asemeComment_375 skipwhite skipempty
syntax match asemeType_373 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeBuiltIn_372 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeClause_371 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeNumber_369 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_367,asemeComment_370 skipwhite skipempty
syntax region asemeComment_370 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_367,asemeComment_370 skipwhite skipempty
syntax match asemeComment_370 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_367,asemeComment_370 skipwhite skipempty
syntax match asemePunctuation_367 /\v\.\./ contained nextgroup=asemeNumber_366,asemeComment_368 skipwhite skipempty
syntax region asemeComment_368 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_366,asemeComment_368 skipwhite skipempty
syntax match asemeComment_368 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_366,asemeComment_368 skipwhite skipempty
syntax match asemeNumber_366 /\v\-?\_s*[0-9]+%(\.[0-9]+)?%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemePunctuation_364 /\v\[/ contained nextgroup=asemeNumber_362,asemeComment_365 skipwhite skipempty
syntax region asemeComment_365 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_362,asemeComment_365 skipwhite skipempty
syntax match asemeComment_365 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_362,asemeComment_365 skipwhite skipempty
syntax match asemeNumber_362 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_361,asemeComment_363 skipwhite skipempty
syntax region asemeComment_363 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_361,asemeComment_363 skipwhite skipempty
syntax match asemeComment_363 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_361,asemeComment_363 skipwhite skipempty
syntax match asemePunctuation_361 /\v\]/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeClause_360 /\vlist%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeClause_358 /\vof%(<|>)/ contained nextgroup=asemeBuiltIn_355,asemeType_357,asemeComment_359 skipwhite skipempty
syntax region asemeComment_359 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_355,asemeType_357,asemeComment_359 skipwhite skipempty
syntax match asemeComment_359 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_355,asemeType_357,asemeComment_359 skipwhite skipempty
syntax match asemeType_357 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeBuiltIn_355 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax region asemeComment_356 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeComment_356 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_356 skipwhite skipempty
syntax match asemeDeclaration_353 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_351,asemeComment_354 skipwhite skipempty
syntax region asemeComment_354 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_351,asemeComment_354 skipwhite skipempty
syntax match asemeComment_354 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_351,asemeComment_354 skipwhite skipempty
syntax match asemeReference_351 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_349,asemeComment_352 skipwhite skipempty
syntax region asemeComment_352 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_349,asemeComment_352 skipwhite skipempty
syntax match asemeComment_352 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_349,asemeComment_352 skipwhite skipempty
syntax match asemePunctuation_349 /\v\./ contained nextgroup=asemeReference_348,asemeComment_350 skipwhite skipempty
syntax region asemeComment_350 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_348,asemeComment_350 skipwhite skipempty
syntax match asemeComment_350 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_348,asemeComment_350 skipwhite skipempty
syntax match asemeReference_348 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax cluster asemePlaysInBodyOfParticipant contains=asemeClause_292,asemeClause_296,asemeClause_325,asemeClause_327,asemePunctuation_336,asemePunctuation_339,asemeOperator_341,asemeReference_345,asemeReference_347
syntax match asemeReference_347 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax match asemeReference_345 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_343,asemeComment_346 skipwhite skipempty
syntax region asemeComment_346 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_343,asemeComment_346 skipwhite skipempty
syntax match asemeComment_346 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_343,asemeComment_346 skipwhite skipempty
syntax match asemePunctuation_343 /\v\./ contained nextgroup=asemeReference_342,asemeComment_344 skipwhite skipempty
syntax region asemeComment_344 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_342,asemeComment_344 skipwhite skipempty
syntax match asemeComment_344 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_342,asemeComment_344 skipwhite skipempty
syntax match asemeReference_342 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax match asemeOperator_341 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemePunctuation_339 /\v\./ contained nextgroup=asemeReference_338,asemeComment_340 skipwhite skipempty
syntax region asemeComment_340 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_338,asemeComment_340 skipwhite skipempty
syntax match asemeComment_340 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_338,asemeComment_340 skipwhite skipempty
syntax match asemeReference_338 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax match asemePunctuation_336 /\v\,/ contained nextgroup=asemeReference_331,asemeReference_334,asemeComment_337 skipwhite skipempty
syntax region asemeComment_337 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_331,asemeReference_334,asemeComment_337 skipwhite skipempty
syntax match asemeComment_337 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_331,asemeReference_334,asemeComment_337 skipwhite skipempty
syntax match asemeReference_334 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_333,asemeComment_335 skipwhite skipempty
syntax region asemeComment_335 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_333,asemeComment_335 skipwhite skipempty
syntax match asemeComment_335 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_333,asemeComment_335 skipwhite skipempty
syntax match asemeOperator_333 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeReference_331 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*%(\_s*\.)@=)?%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_329,asemeComment_332 skipwhite skipempty
syntax region asemeComment_332 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_329,asemeComment_332 skipwhite skipempty
syntax match asemeComment_332 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_329,asemeComment_332 skipwhite skipempty
syntax match asemePunctuation_329 /\v\./ contained nextgroup=asemeReference_328,asemeComment_330 skipwhite skipempty
syntax region asemeComment_330 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_328,asemeComment_330 skipwhite skipempty
syntax match asemeComment_330 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_328,asemeComment_330 skipwhite skipempty
syntax match asemeReference_328 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax match asemeClause_327 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_325 /\vwhen%(<|>)/ contained nextgroup=asemeClause_324,asemeComment_326 skipwhite skipempty
syntax region asemeComment_326 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_324,asemeComment_326 skipwhite skipempty
syntax match asemeComment_326 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_324,asemeComment_326 skipwhite skipempty
syntax match asemeClause_324 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_296 /\vas%(<|>)/ contained nextgroup=asemeReference_294,asemeComment_297 skipwhite skipempty
syntax region asemeComment_297 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_294,asemeComment_297 skipwhite skipempty
syntax match asemeComment_297 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_294,asemeComment_297 skipwhite skipempty
syntax match asemeReference_294 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax region asemeComment_295 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax match asemeComment_295 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_295 skipwhite skipempty
syntax match asemeClause_292 /\vwith%(<|>)/ contained nextgroup=asemeReference_290,asemeComment_293 skipwhite skipempty
syntax region asemeComment_293 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_290,asemeComment_293 skipwhite skipempty
syntax match asemeComment_293 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_290,asemeComment_293 skipwhite skipempty
syntax match asemeReference_290 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_289,asemeComment_291 skipwhite skipempty
syntax region asemeComment_291 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_289,asemeComment_291 skipwhite skipempty
syntax match asemeComment_291 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_289,asemeComment_291 skipwhite skipempty
syntax match asemeOperator_289 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeDeclaration_256 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_255,asemeComment_257 skipwhite skipempty
syntax region asemeComment_257 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_255,asemeComment_257 skipwhite skipempty
syntax match asemeComment_257 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_255,asemeComment_257 skipwhite skipempty
syntax match asemeText_255 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_254 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax match asemePunctuation_252 /\v\.\./ contained nextgroup=asemeNumber_251,asemeComment_253 skipwhite skipempty
syntax region asemeComment_253 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_251,asemeComment_253 skipwhite skipempty
syntax match asemeComment_253 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_251,asemeComment_253 skipwhite skipempty
syntax match asemeNumber_251 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax match asemePunctuation_249 /\v\[/ contained nextgroup=asemeNumber_247,asemeComment_250 skipwhite skipempty
syntax region asemeComment_250 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_247,asemeComment_250 skipwhite skipempty
syntax match asemeComment_250 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_247,asemeComment_250 skipwhite skipempty
syntax match asemeNumber_247 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax region asemeComment_248 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax match asemeComment_248 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_248 skipwhite skipempty
syntax match asemeDeclaration_245 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_246 skipwhite skipempty
syntax region asemeComment_246 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_246 skipwhite skipempty
syntax match asemeComment_246 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_246 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_244
syntax region asemePunctuation_244 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_224,asemeDeclaration_242,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_242 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_241,asemeComment_243 skipwhite skipempty
syntax region asemeComment_243 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_241,asemeComment_243 skipwhite skipempty
syntax match asemeComment_243 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_241,asemeComment_243 skipwhite skipempty
syntax match asemeName_241 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_228,asemeClause_231,asemeClause_234,asemePunctuation_237,asemeText_239,asemeName_240
syntax match asemeName_240 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemeText_239 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemePunctuation_237 /\v\,/ contained nextgroup=asemeReference_236,asemeComment_238 skipwhite skipempty
syntax region asemeComment_238 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_236,asemeComment_238 skipwhite skipempty
syntax match asemeComment_238 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_236,asemeComment_238 skipwhite skipempty
syntax match asemeReference_236 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemeClause_234 /\vrealises%(<|>)/ contained nextgroup=asemeReference_233,asemeComment_235 skipwhite skipempty
syntax region asemeComment_235 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_233,asemeComment_235 skipwhite skipempty
syntax match asemeComment_235 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_233,asemeComment_235 skipwhite skipempty
syntax match asemeReference_233 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemeClause_231 /\vincludes%(<|>)/ contained nextgroup=asemeReference_230,asemeComment_232 skipwhite skipempty
syntax region asemeComment_232 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_230,asemeComment_232 skipwhite skipempty
syntax match asemeComment_232 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_230,asemeComment_232 skipwhite skipempty
syntax match asemeReference_230 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemeClause_228 /\vby%(<|>)/ contained nextgroup=asemeReference_226,asemeComment_229 skipwhite skipempty
syntax region asemeComment_229 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_226,asemeComment_229 skipwhite skipempty
syntax match asemeComment_229 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_226,asemeComment_229 skipwhite skipempty
syntax match asemeReference_226 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax region asemeComment_227 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemeComment_227 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_227 skipwhite skipempty
syntax match asemeDeclaration_224 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_223,asemeComment_225 skipwhite skipempty
syntax region asemeComment_225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_223,asemeComment_225 skipwhite skipempty
syntax match asemeComment_225 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_223,asemeComment_225 skipwhite skipempty
syntax match asemeReference_223 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemeChoice_214,asemePunctuation_217,asemePunctuation_220,asemeReference_222
syntax match asemeReference_222 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax match asemePunctuation_220 /\v\:/ contained nextgroup=asemeChoice_219,asemeComment_221 skipwhite skipempty
syntax region asemeComment_221 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_219,asemeComment_221 skipwhite skipempty
syntax match asemeComment_221 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_219,asemeComment_221 skipwhite skipempty
syntax match asemeChoice_219 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax match asemePunctuation_217 /\v\,/ contained nextgroup=asemeReference_216,asemeComment_218 skipwhite skipempty
syntax region asemeComment_218 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_216,asemeComment_218 skipwhite skipempty
syntax match asemeComment_218 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_216,asemeComment_218 skipwhite skipempty
syntax match asemeReference_216 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax match asemeChoice_214 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax region asemeComment_215 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax match asemeComment_215 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_215 skipwhite skipempty
syntax match asemeDeclaration_212 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_213 skipwhite skipempty
syntax region asemeComment_213 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_213 skipwhite skipempty
syntax match asemeComment_213 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_213 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_211
syntax region asemePunctuation_211 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_209,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_209 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_208,asemeComment_210 skipwhite skipempty
syntax region asemeComment_210 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_208,asemeComment_210 skipwhite skipempty
syntax match asemeComment_210 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_208,asemeComment_210 skipwhite skipempty
syntax match asemeBlock_208 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_207 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_205,asemeBlock_206
syntax match asemeBlock_206 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_207 skipwhite skipempty
syntax region asemeComment_207 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_207 skipwhite skipempty
syntax match asemeComment_207 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_207 skipwhite skipempty
syntax region asemePunctuation_205 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_203,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_203 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_202,asemeComment_204 skipwhite skipempty
syntax region asemeComment_204 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_202,asemeComment_204 skipwhite skipempty
syntax match asemeComment_204 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_202,asemeComment_204 skipwhite skipempty
syntax match asemeName_202 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_192,asemeClause_195,asemePunctuation_198,asemeText_200,asemeName_201
syntax match asemeName_201 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax match asemeText_200 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax match asemePunctuation_198 /\v\,/ contained nextgroup=asemeReference_197,asemeComment_199 skipwhite skipempty
syntax region asemeComment_199 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_197,asemeComment_199 skipwhite skipempty
syntax match asemeComment_199 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_197,asemeComment_199 skipwhite skipempty
syntax match asemeReference_197 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax match asemeClause_195 /\von%(<|>)/ contained nextgroup=asemeReference_194,asemeComment_196 skipwhite skipempty
syntax region asemeComment_196 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_194,asemeComment_196 skipwhite skipempty
syntax match asemeComment_196 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_194,asemeComment_196 skipwhite skipempty
syntax match asemeReference_194 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax match asemeClause_192 /\vdepends%(<|>)/ contained nextgroup=asemeClause_190,asemeComment_193 skipwhite skipempty
syntax region asemeComment_193 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_190,asemeComment_193 skipwhite skipempty
syntax match asemeComment_193 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_190,asemeComment_193 skipwhite skipempty
syntax match asemeClause_190 /\von%(<|>)/ contained nextgroup=asemeReference_188,asemeComment_191 skipwhite skipempty
syntax region asemeComment_191 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_188,asemeComment_191 skipwhite skipempty
syntax match asemeComment_191 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_188,asemeComment_191 skipwhite skipempty
syntax match asemeReference_188 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_189 skipwhite skipempty
syntax match asemeDeclaration_186 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_184,asemeComment_187 skipwhite skipempty
syntax region asemeComment_187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_184,asemeComment_187 skipwhite skipempty
syntax match asemeComment_187 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_184,asemeComment_187 skipwhite skipempty
syntax match asemeName_184 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_183,asemeComment_185 skipwhite skipempty
syntax region asemeComment_185 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_183,asemeComment_185 skipwhite skipempty
syntax match asemeComment_185 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_183,asemeComment_185 skipwhite skipempty
syntax match asemePunctuation_183 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_156,asemePunctuation_164,asemePunctuation_170,asemeOperator_173,asemePunctuation_175,asemeBuiltIn_177,asemeType_179,asemeName_181
syntax match asemeName_181 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_180,asemeComment_182 skipwhite skipempty
syntax region asemeComment_182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_180,asemeComment_182 skipwhite skipempty
syntax match asemeComment_182 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_180,asemeComment_182 skipwhite skipempty
syntax match asemePunctuation_180 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemeType_179 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_176,asemeComment_178 skipwhite skipempty
syntax match asemeBuiltIn_177 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_176,asemeComment_178 skipwhite skipempty
syntax region asemeComment_178 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_176,asemeComment_178 skipwhite skipempty
syntax match asemeComment_178 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_176,asemeComment_178 skipwhite skipempty
syntax match asemeName_176 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemePunctuation_175 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemeOperator_173 /\v\=%(\=)@!/ contained nextgroup=asemeText_172,asemeComment_174 skipwhite skipempty
syntax region asemeComment_174 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_172,asemeComment_174 skipwhite skipempty
syntax match asemeComment_174 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_172,asemeComment_174 skipwhite skipempty
syntax match asemeText_172 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemePunctuation_170 /\v\,/ contained nextgroup=asemeBuiltIn_167,asemeType_169,asemeComment_171 skipwhite skipempty
syntax region asemeComment_171 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_167,asemeType_169,asemeComment_171 skipwhite skipempty
syntax match asemeComment_171 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_167,asemeType_169,asemeComment_171 skipwhite skipempty
syntax match asemeType_169 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_166,asemeComment_168 skipwhite skipempty
syntax match asemeBuiltIn_167 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_166,asemeComment_168 skipwhite skipempty
syntax region asemeComment_168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_166,asemeComment_168 skipwhite skipempty
syntax match asemeComment_168 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_166,asemeComment_168 skipwhite skipempty
syntax match asemeName_166 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemePunctuation_164 /\v\:/ contained nextgroup=asemeBuiltIn_161,asemeType_163,asemeComment_165 skipwhite skipempty
syntax region asemeComment_165 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_161,asemeType_163,asemeComment_165 skipwhite skipempty
syntax match asemeComment_165 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_161,asemeType_163,asemeComment_165 skipwhite skipempty
syntax match asemeType_163 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_159,asemeComment_162 skipwhite skipempty
syntax match asemeBuiltIn_161 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_159,asemeComment_162 skipwhite skipempty
syntax region asemeComment_162 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_159,asemeComment_162 skipwhite skipempty
syntax match asemeComment_162 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_159,asemeComment_162 skipwhite skipempty
syntax match asemeOperator_159 /\v\=%(\=)@!/ contained nextgroup=asemeText_158,asemeComment_160 skipwhite skipempty
syntax region asemeComment_160 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_158,asemeComment_160 skipwhite skipempty
syntax match asemeComment_160 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_158,asemeComment_160 skipwhite skipempty
syntax match asemeText_158 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemePunctuation_156 /\v\)/ contained nextgroup=asemePunctuation_154,asemeComment_157 skipwhite skipempty
syntax region asemeComment_157 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_154,asemeComment_157 skipwhite skipempty
syntax match asemeComment_157 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_154,asemeComment_157 skipwhite skipempty
syntax match asemePunctuation_154 /\v\:/ contained nextgroup=asemeBuiltIn_151,asemeType_153,asemeComment_155 skipwhite skipempty
syntax region asemeComment_155 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_151,asemeType_153,asemeComment_155 skipwhite skipempty
syntax match asemeComment_155 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_151,asemeType_153,asemeComment_155 skipwhite skipempty
syntax match asemeType_153 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_149,asemeComment_152 skipwhite skipempty
syntax match asemeBuiltIn_151 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_149,asemeComment_152 skipwhite skipempty
syntax region asemeComment_152 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_149,asemeComment_152 skipwhite skipempty
syntax match asemeComment_152 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_149,asemeComment_152 skipwhite skipempty
syntax match asemeOperator_149 /\v\=%(\=)@!/ contained nextgroup=asemeText_147,asemeComment_150 skipwhite skipempty
syntax region asemeComment_150 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_147,asemeComment_150 skipwhite skipempty
syntax match asemeComment_150 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_147,asemeComment_150 skipwhite skipempty
syntax match asemeText_147 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax region asemeComment_148 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemeComment_148 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_148 skipwhite skipempty
syntax match asemeDeclaration_145 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_144,asemeComment_146 skipwhite skipempty
syntax region asemeComment_146 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_144,asemeComment_146 skipwhite skipempty
syntax match asemeComment_146 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_144,asemeComment_146 skipwhite skipempty
syntax match asemeBlock_144 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_115,asemeClause_118,asemeClause_121,asemePunctuation_142,asemeBlock_143
syntax match asemeBlock_143 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax region asemePunctuation_142 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_140,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeDeclaration_140 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_139,asemeComment_141 skipwhite skipempty
syntax region asemeComment_141 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_139,asemeComment_141 skipwhite skipempty
syntax match asemeComment_141 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_139,asemeComment_141 skipwhite skipempty
syntax match asemeReference_139 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_125,asemeClause_128,asemeClause_131,asemeChoice_133,asemePunctuation_136,asemeReference_138
syntax match asemeReference_138 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemePunctuation_136 /\v\,/ contained nextgroup=asemeReference_134,asemeReference_135,asemeComment_137 skipwhite skipempty
syntax region asemeComment_137 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_134,asemeReference_135,asemeComment_137 skipwhite skipempty
syntax match asemeComment_137 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_134,asemeReference_135,asemeComment_137 skipwhite skipempty
syntax match asemeReference_135 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeReference_134 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeChoice_133 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeClause_131 /\vexpires%(<|>)/ contained nextgroup=asemeNumber_130,asemeComment_132 skipwhite skipempty
syntax region asemeComment_132 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_130,asemeComment_132 skipwhite skipempty
syntax match asemeComment_132 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_130,asemeComment_132 skipwhite skipempty
syntax match asemeNumber_130 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeClause_128 /\vevery%(<|>)/ contained nextgroup=asemeNumber_127,asemeComment_129 skipwhite skipempty
syntax region asemeComment_129 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_127,asemeComment_129 skipwhite skipempty
syntax match asemeComment_129 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_127,asemeComment_129 skipwhite skipempty
syntax match asemeNumber_127 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeClause_125 /\vfrom%(<|>)/ contained nextgroup=asemeReference_123,asemeComment_126 skipwhite skipempty
syntax region asemeComment_126 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_123,asemeComment_126 skipwhite skipempty
syntax match asemeComment_126 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_123,asemeComment_126 skipwhite skipempty
syntax match asemeReference_123 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax region asemeComment_124 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeComment_124 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_124 skipwhite skipempty
syntax match asemeClause_121 /\vdelay%(<|>)/ contained nextgroup=asemeNumber_120,asemeComment_122 skipwhite skipempty
syntax region asemeComment_122 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_120,asemeComment_122 skipwhite skipempty
syntax match asemeComment_122 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_120,asemeComment_122 skipwhite skipempty
syntax match asemeNumber_120 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax match asemeClause_118 /\vradio%(<|>)/ contained nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax region asemeComment_119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax match asemeComment_119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax match asemeNumber_117 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax match asemeClause_115 /\vunder%(<|>)/ contained nextgroup=asemeReference_113,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_113,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_113,asemeComment_116 skipwhite skipempty
syntax match asemeReference_113 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax region asemeComment_114 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax match asemeComment_114 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_114 skipwhite skipempty
syntax match asemeDeclaration_111 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_110,asemeComment_112 skipwhite skipempty
syntax region asemeComment_112 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_110,asemeComment_112 skipwhite skipempty
syntax match asemeComment_112 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_110,asemeComment_112 skipwhite skipempty
syntax match asemeBlock_110 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_109 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_107,asemeBlock_108
syntax match asemeBlock_108 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_109 skipwhite skipempty
syntax region asemeComment_109 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_109 skipwhite skipempty
syntax match asemeComment_109 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_109 skipwhite skipempty
syntax region asemePunctuation_107 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_101,asemeBuiltIn_104,asemeType_106,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeType_106 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_103,asemeComment_105 skipwhite skipempty
syntax match asemeBuiltIn_104 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_103,asemeComment_105 skipwhite skipempty
syntax region asemeComment_105 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_103,asemeComment_105 skipwhite skipempty
syntax match asemeComment_105 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_103,asemeComment_105 skipwhite skipempty
syntax match asemeName_103 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax match asemeDeclaration_101 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_98,asemeType_100,asemeComment_102 skipwhite skipempty
syntax region asemeComment_102 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_98,asemeType_100,asemeComment_102 skipwhite skipempty
syntax match asemeComment_102 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_98,asemeType_100,asemeComment_102 skipwhite skipempty
syntax match asemeType_100 /\v[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_97,asemeComment_99 skipwhite skipempty
syntax match asemeBuiltIn_98 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_97,asemeComment_99 skipwhite skipempty
syntax region asemeComment_99 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_97,asemeComment_99 skipwhite skipempty
syntax match asemeComment_99 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_97,asemeComment_99 skipwhite skipempty
syntax match asemeName_97 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_89,asemePunctuation_91,asemeBuiltIn_93,asemeType_95,asemeName_96
syntax match asemeName_96 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax match asemeType_95 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@![A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_92,asemeComment_94 skipwhite skipempty
syntax match asemeBuiltIn_93 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_]%([A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)?%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!))@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_92,asemeComment_94 skipwhite skipempty
syntax region asemeComment_94 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_92,asemeComment_94 skipwhite skipempty
syntax match asemeComment_94 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_92,asemeComment_94 skipwhite skipempty
syntax match asemeName_92 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax match asemePunctuation_91 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax match asemeOperator_89 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_87,asemeComment_90 skipwhite skipempty
syntax region asemeComment_90 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_87,asemeComment_90 skipwhite skipempty
syntax match asemeComment_90 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_87,asemeComment_90 skipwhite skipempty
syntax match asemeNumber_87 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax region asemeComment_88 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax match asemeComment_88 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_88 skipwhite skipempty
syntax match asemeDeclaration_85 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_84,asemeComment_86 skipwhite skipempty
syntax region asemeComment_86 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_84,asemeComment_86 skipwhite skipempty
syntax match asemeComment_86 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_84,asemeComment_86 skipwhite skipempty
syntax match asemeBlock_84 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_83 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_81,asemeBlock_82
syntax match asemeBlock_82 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_83 skipwhite skipempty
syntax region asemeComment_83 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_83 skipwhite skipempty
syntax match asemeComment_83 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_83 skipwhite skipempty
syntax region asemePunctuation_81 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_80,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemeName_80 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_76 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_77,asemePunctuation_79
syntax match asemePunctuation_79 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_76 skipwhite skipempty
syntax match asemeOperator_77 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_75,asemeComment_78 skipwhite skipempty
syntax region asemeComment_78 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_75,asemeComment_78 skipwhite skipempty
syntax match asemeComment_78 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_75,asemeComment_78 skipwhite skipempty
syntax match asemeNumber_75 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_76 skipwhite skipempty
syntax region asemeComment_76 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_76 skipwhite skipempty
syntax match asemeComment_76 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_76 skipwhite skipempty
syntax match asemeDeclaration_73 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_71,asemeComment_74 skipwhite skipempty
syntax region asemeComment_74 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_71,asemeComment_74 skipwhite skipempty
syntax match asemeComment_74 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_71,asemeComment_74 skipwhite skipempty
syntax match asemeName_71 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_70,asemeComment_72 skipwhite skipempty
syntax region asemeComment_72 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_70,asemeComment_72 skipwhite skipempty
syntax match asemeComment_72 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_70,asemeComment_72 skipwhite skipempty
syntax match asemeOperator_70 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_1225,asemeClause_1228,asemeText_1230,asemeNumber_1231,asemeTruth_1232,asemeLogic_1233,asemeClause_1234,asemeClause_1235,asemeClause_1236,asemeClause_1237,asemeClause_1238,asemeClause_1239,asemeClause_1240,asemeClause_1241,asemeClause_1242,asemeClause_1243,asemeClause_1244,asemeClause_1245,asemeCall_1246,asemeReference_1247,asemeOperator_1248,asemePunctuation_1249
syntax match asemePunctuation_1249 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeOperator_1248 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeReference_1247 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeCall_1246 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1245 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1244 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1243 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1242 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1241 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1240 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1239 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1238 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1237 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1236 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1235 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1234 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeLogic_1233 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeTruth_1232 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeNumber_1231 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeText_1230 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeClause_1228 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1227,asemeComment_1229 skipwhite skipempty
syntax region asemeComment_1229 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1227,asemeComment_1229 skipwhite skipempty
syntax match asemeComment_1229 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1227,asemeComment_1229 skipwhite skipempty
syntax match asemeReference_1227 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax match asemeClause_1225 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1223,asemeComment_1226 skipwhite skipempty
syntax region asemeComment_1226 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1223,asemeComment_1226 skipwhite skipempty
syntax match asemeComment_1226 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1223,asemeComment_1226 skipwhite skipempty
syntax match asemeReference_1223 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1221,asemeComment_1224 skipwhite skipempty
syntax region asemeComment_1224 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1221,asemeComment_1224 skipwhite skipempty
syntax match asemeComment_1224 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1221,asemeComment_1224 skipwhite skipempty
syntax match asemeReference_1221 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax region asemeComment_1222 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax match asemeComment_1222 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax region asemePunctuation_1220 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax region asemeComment_1219 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax match asemeComment_1219 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1219 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_1174,asemeClause_1177,asemeText_1179,asemeNumber_1180,asemeTruth_1181,asemeLogic_1182,asemeClause_1183,asemeClause_1184,asemeClause_1185,asemeClause_1186,asemeClause_1187,asemeClause_1188,asemeClause_1189,asemeClause_1190,asemeClause_1191,asemeClause_1192,asemeClause_1193,asemeClause_1194,asemeCall_1195,asemeReference_1196,asemeOperator_1197,asemePunctuation_1198
syntax match asemePunctuation_1198 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeOperator_1197 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeReference_1196 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeCall_1195 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1194 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1193 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1192 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1191 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1190 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1189 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1188 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1187 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1186 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1185 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1184 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1183 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeLogic_1182 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeTruth_1181 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeNumber_1180 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeText_1179 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeClause_1177 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1176,asemeComment_1178 skipwhite skipempty
syntax region asemeComment_1178 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1176,asemeComment_1178 skipwhite skipempty
syntax match asemeComment_1178 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1176,asemeComment_1178 skipwhite skipempty
syntax match asemeReference_1176 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1169,asemeComment_1171 skipwhite skipempty
syntax match asemeClause_1174 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1172,asemeComment_1175 skipwhite skipempty
syntax region asemeComment_1175 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1172,asemeComment_1175 skipwhite skipempty
syntax match asemeComment_1175 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1172,asemeComment_1175 skipwhite skipempty
syntax match asemeReference_1172 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1170,asemeComment_1173 skipwhite skipempty
syntax region asemeComment_1173 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1170,asemeComment_1173 skipwhite skipempty
syntax match asemeComment_1173 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1170,asemeComment_1173 skipwhite skipempty
syntax match asemeReference_1170 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1169,asemeComment_1171 skipwhite skipempty
syntax region asemeComment_1171 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1169,asemeComment_1171 skipwhite skipempty
syntax match asemeComment_1171 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1169,asemeComment_1171 skipwhite skipempty
syntax region asemePunctuation_1169 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax region asemeComment_1168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax match asemeComment_1168 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1168 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_1113,asemeClause_1116,asemeText_1118,asemeNumber_1119,asemeTruth_1120,asemeLogic_1121,asemeClause_1122,asemeClause_1123,asemeClause_1124,asemeClause_1125,asemeClause_1126,asemeClause_1127,asemeClause_1128,asemeClause_1129,asemeClause_1130,asemeClause_1131,asemeClause_1132,asemeClause_1133,asemeCall_1134,asemeReference_1135,asemeOperator_1136,asemePunctuation_1137
syntax match asemePunctuation_1137 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeOperator_1136 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeReference_1135 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeCall_1134 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1133 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1132 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1131 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1130 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1129 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1128 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1127 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1126 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1125 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1124 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1123 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1122 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeLogic_1121 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeTruth_1120 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeNumber_1119 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeText_1118 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeClause_1116 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1115,asemeComment_1117 skipwhite skipempty
syntax region asemeComment_1117 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1115,asemeComment_1117 skipwhite skipempty
syntax match asemeComment_1117 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1115,asemeComment_1117 skipwhite skipempty
syntax match asemeReference_1115 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1108,asemeComment_1110 skipwhite skipempty
syntax match asemeClause_1113 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1111,asemeComment_1114 skipwhite skipempty
syntax region asemeComment_1114 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1111,asemeComment_1114 skipwhite skipempty
syntax match asemeComment_1114 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1111,asemeComment_1114 skipwhite skipempty
syntax match asemeReference_1111 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1109,asemeComment_1112 skipwhite skipempty
syntax region asemeComment_1112 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1109,asemeComment_1112 skipwhite skipempty
syntax match asemeComment_1112 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1109,asemeComment_1112 skipwhite skipempty
syntax match asemeReference_1109 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1108,asemeComment_1110 skipwhite skipempty
syntax region asemeComment_1110 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1108,asemeComment_1110 skipwhite skipempty
syntax match asemeComment_1110 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1108,asemeComment_1110 skipwhite skipempty
syntax region asemePunctuation_1108 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax region asemeComment_1107 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax match asemeComment_1107 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1107 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_904,asemeNumber_906,asemeReference_907,asemeNumber_908,asemeOperator_909,asemePunctuation_910
syntax match asemePunctuation_910 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemeOperator_909 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemeNumber_908 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemeReference_907 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemeNumber_906 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemeText_904 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax region asemeComment_905 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax match asemeComment_905 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_905 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_857,asemeClause_860,asemeText_862,asemeNumber_863,asemeTruth_864,asemeLogic_865,asemeClause_866,asemeClause_867,asemeClause_868,asemeClause_869,asemeClause_870,asemeClause_871,asemeClause_872,asemeClause_873,asemeClause_874,asemeClause_875,asemeClause_876,asemeClause_877,asemeCall_878,asemeReference_879,asemeOperator_880,asemePunctuation_881
syntax match asemePunctuation_881 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeOperator_880 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeReference_879 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeCall_878 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_877 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_876 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_875 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_874 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_873 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_872 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_871 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_870 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_869 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_868 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_867 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_866 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeLogic_865 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeTruth_864 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeNumber_863 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeText_862 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeClause_860 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_859,asemeComment_861 skipwhite skipempty
syntax region asemeComment_861 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_859,asemeComment_861 skipwhite skipempty
syntax match asemeComment_861 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_859,asemeComment_861 skipwhite skipempty
syntax match asemeReference_859 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax match asemeClause_857 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_855,asemeComment_858 skipwhite skipempty
syntax region asemeComment_858 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_855,asemeComment_858 skipwhite skipempty
syntax match asemeComment_858 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_855,asemeComment_858 skipwhite skipempty
syntax match asemeReference_855 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_853,asemeComment_856 skipwhite skipempty
syntax region asemeComment_856 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_853,asemeComment_856 skipwhite skipempty
syntax match asemeComment_856 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_853,asemeComment_856 skipwhite skipempty
syntax match asemeReference_853 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax region asemeComment_854 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax match asemeComment_854 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_852,asemeComment_854 skipwhite skipempty
syntax region asemePunctuation_852 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax region asemeComment_851 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax match asemeComment_851 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_851 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfSrm contains=asemeReference_757,asemeText_759,asemeNumber_760,asemeTruth_761,asemeLogic_762,asemeClause_763,asemeClause_764,asemeClause_765,asemeClause_766,asemeClause_767,asemeClause_768,asemeClause_769,asemeClause_770,asemeClause_771,asemeClause_772,asemeClause_773,asemeClause_774,asemeCall_775,asemeReference_776,asemeOperator_777,asemePunctuation_778
syntax match asemePunctuation_778 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeOperator_777 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeReference_776 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeCall_775 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_774 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_773 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_772 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_771 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_770 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_769 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_768 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_767 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_766 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_765 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_764 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeClause_763 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeLogic_762 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeTruth_761 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeNumber_760 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeText_759 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeReference_757 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_755,asemeComment_758 skipwhite skipempty
syntax region asemeComment_758 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_755,asemeComment_758 skipwhite skipempty
syntax match asemeComment_758 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_755,asemeComment_758 skipwhite skipempty
syntax match asemeReference_755 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_754,asemeComment_756 skipwhite skipempty
syntax region asemeComment_756 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_754,asemeComment_756 skipwhite skipempty
syntax match asemeComment_756 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_754,asemeComment_756 skipwhite skipempty
syntax region asemePunctuation_754 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax region asemeComment_753 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax match asemeComment_753 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_753 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfSrm contains=asemeClause_719,asemeClause_722,asemeText_724,asemeNumber_725,asemeTruth_726,asemeLogic_727,asemeClause_728,asemeClause_729,asemeClause_730,asemeClause_731,asemeClause_732,asemeClause_733,asemeClause_734,asemeClause_735,asemeClause_736,asemeClause_737,asemeClause_738,asemeClause_739,asemeCall_740,asemeReference_741,asemeOperator_742,asemePunctuation_743
syntax match asemePunctuation_743 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeOperator_742 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeReference_741 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeCall_740 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_739 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_738 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_737 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_736 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_735 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_734 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_733 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_732 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_731 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_730 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_729 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_728 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeLogic_727 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeTruth_726 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeNumber_725 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeText_724 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeClause_722 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_721,asemeComment_723 skipwhite skipempty
syntax region asemeComment_723 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_721,asemeComment_723 skipwhite skipempty
syntax match asemeComment_723 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_721,asemeComment_723 skipwhite skipempty
syntax match asemeReference_721 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_714,asemeComment_716 skipwhite skipempty
syntax match asemeClause_719 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax match asemeReference_717 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_715,asemeComment_718 skipwhite skipempty
syntax region asemeComment_718 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_715,asemeComment_718 skipwhite skipempty
syntax match asemeComment_718 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_715,asemeComment_718 skipwhite skipempty
syntax match asemeReference_715 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_714,asemeComment_716 skipwhite skipempty
syntax region asemeComment_716 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_714,asemeComment_716 skipwhite skipempty
syntax match asemeComment_716 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_714,asemeComment_716 skipwhite skipempty
syntax region asemePunctuation_714 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax region asemeComment_713 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeComment_713 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_647,asemeClause_650,asemeText_652,asemeNumber_653,asemeTruth_654,asemeLogic_655,asemeClause_656,asemeClause_657,asemeClause_658,asemeClause_659,asemeClause_660,asemeClause_661,asemeClause_662,asemeClause_663,asemeClause_664,asemeClause_665,asemeClause_666,asemeClause_667,asemeCall_668,asemeReference_669,asemeOperator_670,asemePunctuation_671
syntax match asemePunctuation_671 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeOperator_670 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeReference_669 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeCall_668 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_667 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_666 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_665 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_664 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_663 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_662 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_661 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_660 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_659 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_658 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_657 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_656 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeLogic_655 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeTruth_654 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeNumber_653 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeText_652 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeClause_650 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_649,asemeComment_651 skipwhite skipempty
syntax region asemeComment_651 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_649,asemeComment_651 skipwhite skipempty
syntax match asemeComment_651 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_649,asemeComment_651 skipwhite skipempty
syntax match asemeReference_649 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_642,asemeComment_644 skipwhite skipempty
syntax match asemeClause_647 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_645,asemeComment_648 skipwhite skipempty
syntax region asemeComment_648 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_645,asemeComment_648 skipwhite skipempty
syntax match asemeComment_648 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_645,asemeComment_648 skipwhite skipempty
syntax match asemeReference_645 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_643,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_643,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_643,asemeComment_646 skipwhite skipempty
syntax match asemeReference_643 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_642,asemeComment_644 skipwhite skipempty
syntax region asemeComment_644 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_642,asemeComment_644 skipwhite skipempty
syntax match asemeComment_644 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_642,asemeComment_644 skipwhite skipempty
syntax region asemePunctuation_642 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax region asemeComment_641 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax match asemeComment_641 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_641 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_608,asemeClause_611,asemeText_613,asemeNumber_614,asemeTruth_615,asemeLogic_616,asemeClause_617,asemeClause_618,asemeClause_619,asemeClause_620,asemeClause_621,asemeClause_622,asemeClause_623,asemeClause_624,asemeClause_625,asemeClause_626,asemeClause_627,asemeClause_628,asemeCall_629,asemeReference_630,asemeOperator_631,asemePunctuation_632
syntax match asemePunctuation_632 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeOperator_631 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeReference_630 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeCall_629 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_628 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_627 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_626 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_625 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_624 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_623 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_622 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_621 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_620 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_619 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_618 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_617 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeLogic_616 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeTruth_615 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeNumber_614 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeText_613 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeClause_611 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_610,asemeComment_612 skipwhite skipempty
syntax region asemeComment_612 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_610,asemeComment_612 skipwhite skipempty
syntax match asemeComment_612 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_610,asemeComment_612 skipwhite skipempty
syntax match asemeReference_610 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_603,asemeComment_605 skipwhite skipempty
syntax match asemeClause_608 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_606,asemeComment_609 skipwhite skipempty
syntax region asemeComment_609 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_606,asemeComment_609 skipwhite skipempty
syntax match asemeComment_609 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_606,asemeComment_609 skipwhite skipempty
syntax match asemeReference_606 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_604,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_604,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_604,asemeComment_607 skipwhite skipempty
syntax match asemeReference_604 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_603,asemeComment_605 skipwhite skipempty
syntax region asemeComment_605 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_603,asemeComment_605 skipwhite skipempty
syntax match asemeComment_605 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_603,asemeComment_605 skipwhite skipempty
syntax region asemePunctuation_603 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax region asemeComment_602 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax match asemeComment_602 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_602 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_537,asemeNumber_539,asemeReference_540,asemeNumber_541,asemeOperator_542,asemePunctuation_543
syntax match asemePunctuation_543 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeOperator_542 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeNumber_541 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeReference_540 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeNumber_539 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeText_537 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_538 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant contains=asemeClause_443,asemeClause_446,asemeText_448,asemeNumber_449,asemeTruth_450,asemeLogic_451,asemeClause_452,asemeClause_453,asemeClause_454,asemeClause_455,asemeClause_456,asemeClause_457,asemeClause_458,asemeClause_459,asemeClause_460,asemeClause_461,asemeClause_462,asemeClause_463,asemeCall_464,asemeReference_465,asemeOperator_466,asemePunctuation_467
syntax match asemePunctuation_467 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeOperator_466 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeReference_465 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeCall_464 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_463 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_462 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_461 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_460 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_459 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_458 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_457 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_456 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_455 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_454 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_453 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_452 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeLogic_451 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeTruth_450 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeNumber_449 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeText_448 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeClause_446 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_445,asemeComment_447 skipwhite skipempty
syntax region asemeComment_447 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_445,asemeComment_447 skipwhite skipempty
syntax match asemeComment_447 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_445,asemeComment_447 skipwhite skipempty
syntax match asemeReference_445 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_438,asemeComment_440 skipwhite skipempty
syntax match asemeClause_443 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_441,asemeComment_444 skipwhite skipempty
syntax region asemeComment_444 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_441,asemeComment_444 skipwhite skipempty
syntax match asemeComment_444 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_441,asemeComment_444 skipwhite skipempty
syntax match asemeReference_441 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_439,asemeComment_442 skipwhite skipempty
syntax region asemeComment_442 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_439,asemeComment_442 skipwhite skipempty
syntax match asemeComment_442 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_439,asemeComment_442 skipwhite skipempty
syntax match asemeReference_439 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_438,asemeComment_440 skipwhite skipempty
syntax region asemeComment_440 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_438,asemeComment_440 skipwhite skipempty
syntax match asemeComment_440 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_438,asemeComment_440 skipwhite skipempty
syntax region asemePunctuation_438 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_437 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_386,asemeClause_389,asemeText_391,asemeNumber_392,asemeTruth_393,asemeLogic_394,asemeClause_395,asemeClause_396,asemeClause_397,asemeClause_398,asemeClause_399,asemeClause_400,asemeClause_401,asemeClause_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeClause_406,asemeCall_407,asemeReference_408,asemeOperator_409,asemePunctuation_410
syntax match asemePunctuation_410 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeOperator_409 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeReference_408 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeCall_407 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_406 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_402 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_401 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_400 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_399 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_398 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_397 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_396 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_395 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeLogic_394 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeTruth_393 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeNumber_392 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeText_391 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeClause_389 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_388,asemeComment_390 skipwhite skipempty
syntax region asemeComment_390 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_388,asemeComment_390 skipwhite skipempty
syntax match asemeComment_390 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_388,asemeComment_390 skipwhite skipempty
syntax match asemeReference_388 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax match asemeClause_386 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_384,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_384,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_384,asemeComment_387 skipwhite skipempty
syntax match asemeReference_384 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_382,asemeComment_385 skipwhite skipempty
syntax region asemeComment_385 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_382,asemeComment_385 skipwhite skipempty
syntax match asemeComment_385 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_382,asemeComment_385 skipwhite skipempty
syntax match asemeReference_382 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax region asemeComment_383 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax match asemeComment_383 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax region asemePunctuation_381 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax region asemeComment_380 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax match asemeComment_380 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_380 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeReference_302,asemeText_304,asemeNumber_305,asemeTruth_306,asemeLogic_307,asemeClause_308,asemeClause_309,asemeClause_310,asemeClause_311,asemeClause_312,asemeClause_313,asemeClause_314,asemeClause_315,asemeClause_316,asemeClause_317,asemeClause_318,asemeClause_319,asemeCall_320,asemeReference_321,asemeOperator_322,asemePunctuation_323
syntax match asemePunctuation_323 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeOperator_322 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeReference_321 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeCall_320 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_319 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_318 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_317 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_316 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_315 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_314 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_313 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_312 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_311 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_310 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_309 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeClause_308 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeLogic_307 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeTruth_306 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeNumber_305 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeText_304 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeReference_302 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax region asemeComment_303 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax match asemeComment_303 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_300,asemeComment_303 skipwhite skipempty
syntax match asemeReference_300 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_299,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_299,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_299,asemeComment_301 skipwhite skipempty
syntax region asemePunctuation_299 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax region asemeComment_298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax match asemeComment_298 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_298 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeClause_264,asemeClause_267,asemeText_269,asemeNumber_270,asemeTruth_271,asemeLogic_272,asemeClause_273,asemeClause_274,asemeClause_275,asemeClause_276,asemeClause_277,asemeClause_278,asemeClause_279,asemeClause_280,asemeClause_281,asemeClause_282,asemeClause_283,asemeClause_284,asemeCall_285,asemeReference_286,asemeOperator_287,asemePunctuation_288
syntax match asemePunctuation_288 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeOperator_287 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeReference_286 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeCall_285 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_284 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_283 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_282 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_281 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_280 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_279 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_278 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_277 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_276 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_275 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_274 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_273 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeLogic_272 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeTruth_271 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeNumber_270 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeText_269 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeClause_267 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax region asemeComment_268 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax match asemeComment_268 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax match asemeReference_266 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_259,asemeComment_261 skipwhite skipempty
syntax match asemeClause_264 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_262,asemeComment_265 skipwhite skipempty
syntax region asemeComment_265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_262,asemeComment_265 skipwhite skipempty
syntax match asemeComment_265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_262,asemeComment_265 skipwhite skipempty
syntax match asemeReference_262 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_260,asemeComment_263 skipwhite skipempty
syntax region asemeComment_263 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_260,asemeComment_263 skipwhite skipempty
syntax match asemeComment_263 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_260,asemeComment_263 skipwhite skipempty
syntax match asemeReference_260 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_259,asemeComment_261 skipwhite skipempty
syntax region asemeComment_261 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_259,asemeComment_261 skipwhite skipempty
syntax match asemeComment_261 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_259,asemeComment_261 skipwhite skipempty
syntax region asemePunctuation_259 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax region asemeComment_258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeComment_258 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_45,asemeClause_48,asemeText_50,asemeNumber_51,asemeTruth_52,asemeLogic_53,asemeClause_54,asemeClause_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeClause_59,asemeClause_60,asemeClause_61,asemeClause_62,asemeClause_63,asemeClause_64,asemeClause_65,asemeCall_66,asemeReference_67,asemeOperator_68,asemePunctuation_69
syntax match asemePunctuation_69 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeOperator_68 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeReference_67 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeCall_66 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_65 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_64 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_63 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeLogic_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeTruth_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeNumber_51 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeText_50 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeClause_48 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_47,asemeComment_49 skipwhite skipempty
syntax region asemeComment_49 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_47,asemeComment_49 skipwhite skipempty
syntax match asemeComment_49 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_47,asemeComment_49 skipwhite skipempty
syntax match asemeReference_47 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_40,asemeComment_42 skipwhite skipempty
syntax match asemeClause_45 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_43,asemeComment_46 skipwhite skipempty
syntax region asemeComment_46 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_43,asemeComment_46 skipwhite skipempty
syntax match asemeComment_46 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_43,asemeComment_46 skipwhite skipempty
syntax match asemeReference_43 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_41,asemeComment_44 skipwhite skipempty
syntax region asemeComment_44 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_41,asemeComment_44 skipwhite skipempty
syntax match asemeComment_44 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_41,asemeComment_44 skipwhite skipempty
syntax match asemeReference_41 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_40,asemeComment_42 skipwhite skipempty
syntax region asemeComment_42 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_40,asemeComment_42 skipwhite skipempty
syntax match asemeComment_42 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_40,asemeComment_42 skipwhite skipempty
syntax region asemePunctuation_40 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax region asemeComment_39 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax match asemeComment_39 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_39 skipwhite skipempty
syntax cluster asemeContentOfAMessage contains=asemeText_13,asemeNumber_14,asemeTruth_15,asemeLogic_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeClause_23,asemeClause_24,asemeClause_25,asemeClause_26,asemeClause_27,asemeClause_28,asemeCall_29,asemeReference_30,asemeOperator_31,asemePunctuation_32,asemeText_33,asemeText_34,asemeNumber_35,asemeReference_36,asemeReference_37,asemePunctuation_38,asemeComment
syntax match asemePunctuation_32 /\v%([^ \t{}])@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_31 /\v%([^ \t{}])@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_30 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeCall_29 /\v%([^ \t{}])@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained
syntax match asemeClause_28 /\v%([^ \t{}])@=write_messages%(<|>)%(\_s*\.)@=/ contained
syntax match asemeClause_27 /\v%([^ \t{}])@=read_messages%(<|>)%(\_s*\()@!/ contained
syntax match asemeClause_26 /\v%([^ \t{}])@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_25 /\v%([^ \t{}])@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_24 /\v%([^ \t{}])@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_23 /\v%([^ \t{}])@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained
syntax match asemeClause_22 /\v%([^ \t{}])@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_21 /\v%([^ \t{}])@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained
syntax match asemeClause_20 /\v%([^ \t{}])@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained
syntax match asemeClause_19 /\v%([^ \t{}])@=after%(<|>)%(\_s*\()@=/ contained
syntax match asemeClause_18 /\v%([^ \t{}])@=when%(<|>)/ contained
syntax match asemeClause_17 /\v%([^ \t{}])@=else%(<|>)/ contained
syntax match asemeLogic_16 /\v%([^ \t{}])@=%(and|or|not)%(<|>)/ contained
syntax match asemeTruth_15 /\v%([^ \t{}])@=%(true|false)%(<|>)%(\_s*\.)@!/ contained
syntax match asemeNumber_14 /\v%([^ \t{}])@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_13 /\v%([^ \t{}])@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemeComment start=/\v\/\*/ end=/\v\*\// contains=@Spell
syntax match asemeComment /\v\/\/.*$/ contains=@Spell
highlight default link asemeBlock_1042 asemeBlock
highlight default link asemeBlock_1044 asemeBlock
highlight default link asemeBlock_1056 asemeBlock
highlight default link asemeBlock_1062 asemeBlock
highlight default link asemeBlock_1067 asemeBlock
highlight default link asemeBlock_1068 asemeBlock
highlight default link asemeBlock_1073 asemeBlock
highlight default link asemeBlock_108 asemeBlock
highlight default link asemeBlock_110 asemeBlock
highlight default link asemeBlock_1214 asemeBlock
highlight default link asemeBlock_1216 asemeBlock
highlight default link asemeBlock_1283 asemeBlock
highlight default link asemeBlock_1285 asemeBlock
highlight default link asemeBlock_143 asemeBlock
highlight default link asemeBlock_144 asemeBlock
highlight default link asemeBlock_206 asemeBlock
highlight default link asemeBlock_208 asemeBlock
highlight default link asemeBlock_547 asemeBlock
highlight default link asemeBlock_548 asemeBlock
highlight default link asemeBlock_685 asemeBlock
highlight default link asemeBlock_691 asemeBlock
highlight default link asemeBlock_696 asemeBlock
highlight default link asemeBlock_698 asemeBlock
highlight default link asemeBlock_701 asemeBlock
highlight default link asemeBlock_82 asemeBlock
highlight default link asemeBlock_84 asemeBlock
highlight default link asemeBuiltIn_104 asemeBuiltIn
highlight default link asemeBuiltIn_1143 asemeBuiltIn
highlight default link asemeBuiltIn_1160 asemeBuiltIn
highlight default link asemeBuiltIn_151 asemeBuiltIn
highlight default link asemeBuiltIn_161 asemeBuiltIn
highlight default link asemeBuiltIn_167 asemeBuiltIn
highlight default link asemeBuiltIn_177 asemeBuiltIn
highlight default link asemeBuiltIn_355 asemeBuiltIn
highlight default link asemeBuiltIn_372 asemeBuiltIn
highlight default link asemeBuiltIn_416 asemeBuiltIn
highlight default link asemeBuiltIn_433 asemeBuiltIn
highlight default link asemeBuiltIn_469 asemeBuiltIn
highlight default link asemeBuiltIn_475 asemeBuiltIn
highlight default link asemeBuiltIn_477 asemeBuiltIn
highlight default link asemeBuiltIn_529 asemeBuiltIn
highlight default link asemeBuiltIn_826 asemeBuiltIn
highlight default link asemeBuiltIn_843 asemeBuiltIn
highlight default link asemeBuiltIn_896 asemeBuiltIn
highlight default link asemeBuiltIn_93 asemeBuiltIn
highlight default link asemeBuiltIn_953 asemeBuiltIn
highlight default link asemeBuiltIn_961 asemeBuiltIn
highlight default link asemeBuiltIn_975 asemeBuiltIn
highlight default link asemeBuiltIn_98 asemeBuiltIn
highlight default link asemeCall_1134 asemeCall
highlight default link asemeCall_1195 asemeCall
highlight default link asemeCall_1246 asemeCall
highlight default link asemeCall_285 asemeCall
highlight default link asemeCall_29 asemeCall
highlight default link asemeCall_320 asemeCall
highlight default link asemeCall_407 asemeCall
highlight default link asemeCall_464 asemeCall
highlight default link asemeCall_629 asemeCall
highlight default link asemeCall_66 asemeCall
highlight default link asemeCall_668 asemeCall
highlight default link asemeCall_740 asemeCall
highlight default link asemeCall_775 asemeCall
highlight default link asemeCall_878 asemeCall
highlight default link asemeChoice_1001 asemeChoice
highlight default link asemeChoice_1008 asemeChoice
highlight default link asemeChoice_1020 asemeChoice
highlight default link asemeChoice_1021 asemeChoice
highlight default link asemeChoice_1023 asemeChoice
highlight default link asemeChoice_1082 asemeChoice
highlight default link asemeChoice_1086 asemeChoice
highlight default link asemeChoice_1094 asemeChoice
highlight default link asemeChoice_133 asemeChoice
highlight default link asemeChoice_214 asemeChoice
highlight default link asemeChoice_219 asemeChoice
highlight default link asemeChoice_554 asemeChoice
highlight default link asemeChoice_561 asemeChoice
highlight default link asemeChoice_918 asemeChoice
highlight default link asemeChoice_932 asemeChoice
highlight default link asemeChoice_939 asemeChoice
highlight default link asemeChoice_951 asemeChoice
highlight default link asemeChoice_952 asemeChoice
highlight default link asemeChoice_968 asemeChoice
highlight default link asemeChoice_987 asemeChoice
highlight default link asemeClause_1002 asemeClause
highlight default link asemeClause_1005 asemeClause
highlight default link asemeClause_1011 asemeClause
highlight default link asemeClause_1014 asemeClause
highlight default link asemeClause_1017 asemeClause
highlight default link asemeClause_1019 asemeClause
highlight default link asemeClause_1069 asemeClause
highlight default link asemeClause_1078 asemeClause
highlight default link asemeClause_1113 asemeClause
highlight default link asemeClause_1116 asemeClause
highlight default link asemeClause_1122 asemeClause
highlight default link asemeClause_1123 asemeClause
highlight default link asemeClause_1124 asemeClause
highlight default link asemeClause_1125 asemeClause
highlight default link asemeClause_1126 asemeClause
highlight default link asemeClause_1127 asemeClause
highlight default link asemeClause_1128 asemeClause
highlight default link asemeClause_1129 asemeClause
highlight default link asemeClause_1130 asemeClause
highlight default link asemeClause_1131 asemeClause
highlight default link asemeClause_1132 asemeClause
highlight default link asemeClause_1133 asemeClause
highlight default link asemeClause_1146 asemeClause
highlight default link asemeClause_1148 asemeClause
highlight default link asemeClause_115 asemeClause
highlight default link asemeClause_1159 asemeClause
highlight default link asemeClause_1174 asemeClause
highlight default link asemeClause_1177 asemeClause
highlight default link asemeClause_118 asemeClause
highlight default link asemeClause_1183 asemeClause
highlight default link asemeClause_1184 asemeClause
highlight default link asemeClause_1185 asemeClause
highlight default link asemeClause_1186 asemeClause
highlight default link asemeClause_1187 asemeClause
highlight default link asemeClause_1188 asemeClause
highlight default link asemeClause_1189 asemeClause
highlight default link asemeClause_1190 asemeClause
highlight default link asemeClause_1191 asemeClause
highlight default link asemeClause_1192 asemeClause
highlight default link asemeClause_1193 asemeClause
highlight default link asemeClause_1194 asemeClause
highlight default link asemeClause_121 asemeClause
highlight default link asemeClause_1225 asemeClause
highlight default link asemeClause_1228 asemeClause
highlight default link asemeClause_1234 asemeClause
highlight default link asemeClause_1235 asemeClause
highlight default link asemeClause_1236 asemeClause
highlight default link asemeClause_1237 asemeClause
highlight default link asemeClause_1238 asemeClause
highlight default link asemeClause_1239 asemeClause
highlight default link asemeClause_1240 asemeClause
highlight default link asemeClause_1241 asemeClause
highlight default link asemeClause_1242 asemeClause
highlight default link asemeClause_1243 asemeClause
highlight default link asemeClause_1244 asemeClause
highlight default link asemeClause_1245 asemeClause
highlight default link asemeClause_125 asemeClause
highlight default link asemeClause_1253 asemeClause
highlight default link asemeClause_128 asemeClause
highlight default link asemeClause_131 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_190 asemeClause
highlight default link asemeClause_192 asemeClause
highlight default link asemeClause_195 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_228 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_231 asemeClause
highlight default link asemeClause_234 asemeClause
highlight default link asemeClause_24 asemeClause
highlight default link asemeClause_25 asemeClause
highlight default link asemeClause_26 asemeClause
highlight default link asemeClause_264 asemeClause
highlight default link asemeClause_267 asemeClause
highlight default link asemeClause_27 asemeClause
highlight default link asemeClause_273 asemeClause
highlight default link asemeClause_274 asemeClause
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
highlight default link asemeClause_292 asemeClause
highlight default link asemeClause_296 asemeClause
highlight default link asemeClause_308 asemeClause
highlight default link asemeClause_309 asemeClause
highlight default link asemeClause_310 asemeClause
highlight default link asemeClause_311 asemeClause
highlight default link asemeClause_312 asemeClause
highlight default link asemeClause_313 asemeClause
highlight default link asemeClause_314 asemeClause
highlight default link asemeClause_315 asemeClause
highlight default link asemeClause_316 asemeClause
highlight default link asemeClause_317 asemeClause
highlight default link asemeClause_318 asemeClause
highlight default link asemeClause_319 asemeClause
highlight default link asemeClause_324 asemeClause
highlight default link asemeClause_325 asemeClause
highlight default link asemeClause_327 asemeClause
highlight default link asemeClause_358 asemeClause
highlight default link asemeClause_360 asemeClause
highlight default link asemeClause_371 asemeClause
highlight default link asemeClause_386 asemeClause
highlight default link asemeClause_389 asemeClause
highlight default link asemeClause_395 asemeClause
highlight default link asemeClause_396 asemeClause
highlight default link asemeClause_397 asemeClause
highlight default link asemeClause_398 asemeClause
highlight default link asemeClause_399 asemeClause
highlight default link asemeClause_400 asemeClause
highlight default link asemeClause_401 asemeClause
highlight default link asemeClause_402 asemeClause
highlight default link asemeClause_403 asemeClause
highlight default link asemeClause_404 asemeClause
highlight default link asemeClause_405 asemeClause
highlight default link asemeClause_406 asemeClause
highlight default link asemeClause_443 asemeClause
highlight default link asemeClause_446 asemeClause
highlight default link asemeClause_45 asemeClause
highlight default link asemeClause_452 asemeClause
highlight default link asemeClause_453 asemeClause
highlight default link asemeClause_454 asemeClause
highlight default link asemeClause_455 asemeClause
highlight default link asemeClause_456 asemeClause
highlight default link asemeClause_457 asemeClause
highlight default link asemeClause_458 asemeClause
highlight default link asemeClause_459 asemeClause
highlight default link asemeClause_460 asemeClause
highlight default link asemeClause_461 asemeClause
highlight default link asemeClause_462 asemeClause
highlight default link asemeClause_463 asemeClause
highlight default link asemeClause_48 asemeClause
highlight default link asemeClause_492 asemeClause
highlight default link asemeClause_495 asemeClause
highlight default link asemeClause_497 asemeClause
highlight default link asemeClause_54 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_557 asemeClause
highlight default link asemeClause_559 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_563 asemeClause
highlight default link asemeClause_566 asemeClause
highlight default link asemeClause_568 asemeClause
highlight default link asemeClause_569 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_572 asemeClause
highlight default link asemeClause_574 asemeClause
highlight default link asemeClause_575 asemeClause
highlight default link asemeClause_576 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_59 asemeClause
highlight default link asemeClause_597 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_608 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_611 asemeClause
highlight default link asemeClause_617 asemeClause
highlight default link asemeClause_618 asemeClause
highlight default link asemeClause_619 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_620 asemeClause
highlight default link asemeClause_621 asemeClause
highlight default link asemeClause_622 asemeClause
highlight default link asemeClause_623 asemeClause
highlight default link asemeClause_624 asemeClause
highlight default link asemeClause_625 asemeClause
highlight default link asemeClause_626 asemeClause
highlight default link asemeClause_627 asemeClause
highlight default link asemeClause_628 asemeClause
highlight default link asemeClause_63 asemeClause
highlight default link asemeClause_64 asemeClause
highlight default link asemeClause_647 asemeClause
highlight default link asemeClause_65 asemeClause
highlight default link asemeClause_650 asemeClause
highlight default link asemeClause_656 asemeClause
highlight default link asemeClause_657 asemeClause
highlight default link asemeClause_658 asemeClause
highlight default link asemeClause_659 asemeClause
highlight default link asemeClause_660 asemeClause
highlight default link asemeClause_661 asemeClause
highlight default link asemeClause_662 asemeClause
highlight default link asemeClause_663 asemeClause
highlight default link asemeClause_664 asemeClause
highlight default link asemeClause_665 asemeClause
highlight default link asemeClause_666 asemeClause
highlight default link asemeClause_667 asemeClause
highlight default link asemeClause_703 asemeClause
highlight default link asemeClause_719 asemeClause
highlight default link asemeClause_722 asemeClause
highlight default link asemeClause_728 asemeClause
highlight default link asemeClause_729 asemeClause
highlight default link asemeClause_730 asemeClause
highlight default link asemeClause_731 asemeClause
highlight default link asemeClause_732 asemeClause
highlight default link asemeClause_733 asemeClause
highlight default link asemeClause_734 asemeClause
highlight default link asemeClause_735 asemeClause
highlight default link asemeClause_736 asemeClause
highlight default link asemeClause_737 asemeClause
highlight default link asemeClause_738 asemeClause
highlight default link asemeClause_739 asemeClause
highlight default link asemeClause_747 asemeClause
highlight default link asemeClause_751 asemeClause
highlight default link asemeClause_763 asemeClause
highlight default link asemeClause_764 asemeClause
highlight default link asemeClause_765 asemeClause
highlight default link asemeClause_766 asemeClause
highlight default link asemeClause_767 asemeClause
highlight default link asemeClause_768 asemeClause
highlight default link asemeClause_769 asemeClause
highlight default link asemeClause_770 asemeClause
highlight default link asemeClause_771 asemeClause
highlight default link asemeClause_772 asemeClause
highlight default link asemeClause_773 asemeClause
highlight default link asemeClause_774 asemeClause
highlight default link asemeClause_779 asemeClause
highlight default link asemeClause_780 asemeClause
highlight default link asemeClause_782 asemeClause
highlight default link asemeClause_8 asemeClause
highlight default link asemeClause_829 asemeClause
highlight default link asemeClause_831 asemeClause
highlight default link asemeClause_842 asemeClause
highlight default link asemeClause_857 asemeClause
highlight default link asemeClause_860 asemeClause
highlight default link asemeClause_866 asemeClause
highlight default link asemeClause_867 asemeClause
highlight default link asemeClause_868 asemeClause
highlight default link asemeClause_869 asemeClause
highlight default link asemeClause_870 asemeClause
highlight default link asemeClause_871 asemeClause
highlight default link asemeClause_872 asemeClause
highlight default link asemeClause_873 asemeClause
highlight default link asemeClause_874 asemeClause
highlight default link asemeClause_875 asemeClause
highlight default link asemeClause_876 asemeClause
highlight default link asemeClause_877 asemeClause
highlight default link asemeClause_921 asemeClause
highlight default link asemeClause_924 asemeClause
highlight default link asemeClause_927 asemeClause
highlight default link asemeClause_930 asemeClause
highlight default link asemeClause_933 asemeClause
highlight default link asemeClause_936 asemeClause
highlight default link asemeClause_942 asemeClause
highlight default link asemeClause_945 asemeClause
highlight default link asemeClause_948 asemeClause
highlight default link asemeClause_950 asemeClause
highlight default link asemeClause_990 asemeClause
highlight default link asemeClause_993 asemeClause
highlight default link asemeClause_996 asemeClause
highlight default link asemeClause_999 asemeClause
highlight default link asemeComment_1000 asemeComment
highlight default link asemeComment_1003 asemeComment
highlight default link asemeComment_1006 asemeComment
highlight default link asemeComment_1009 asemeComment
highlight default link asemeComment_1012 asemeComment
highlight default link asemeComment_1015 asemeComment
highlight default link asemeComment_1018 asemeComment
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_1024 asemeComment
highlight default link asemeComment_1029 asemeComment
highlight default link asemeComment_1032 asemeComment
highlight default link asemeComment_1037 asemeComment
highlight default link asemeComment_1040 asemeComment
highlight default link asemeComment_1043 asemeComment
highlight default link asemeComment_1046 asemeComment
highlight default link asemeComment_1048 asemeComment
highlight default link asemeComment_105 asemeComment
highlight default link asemeComment_1050 asemeComment
highlight default link asemeComment_1054 asemeComment
highlight default link asemeComment_1057 asemeComment
highlight default link asemeComment_1060 asemeComment
highlight default link asemeComment_1063 asemeComment
highlight default link asemeComment_1065 asemeComment
highlight default link asemeComment_1070 asemeComment
highlight default link asemeComment_1072 asemeComment
highlight default link asemeComment_1075 asemeComment
highlight default link asemeComment_1077 asemeComment
highlight default link asemeComment_1079 asemeComment
highlight default link asemeComment_1083 asemeComment
highlight default link asemeComment_1087 asemeComment
highlight default link asemeComment_1089 asemeComment
highlight default link asemeComment_109 asemeComment
highlight default link asemeComment_1095 asemeComment
highlight default link asemeComment_1097 asemeComment
highlight default link asemeComment_1099 asemeComment
highlight default link asemeComment_1102 asemeComment
highlight default link asemeComment_1104 asemeComment
highlight default link asemeComment_1106 asemeComment
highlight default link asemeComment_1107 asemeComment
highlight default link asemeComment_1110 asemeComment
highlight default link asemeComment_1112 asemeComment
highlight default link asemeComment_1114 asemeComment
highlight default link asemeComment_1117 asemeComment
highlight default link asemeComment_112 asemeComment
highlight default link asemeComment_114 asemeComment
highlight default link asemeComment_1140 asemeComment
highlight default link asemeComment_1142 asemeComment
highlight default link asemeComment_1144 asemeComment
highlight default link asemeComment_1147 asemeComment
highlight default link asemeComment_1151 asemeComment
highlight default link asemeComment_1153 asemeComment
highlight default link asemeComment_1156 asemeComment
highlight default link asemeComment_1158 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_1163 asemeComment
highlight default link asemeComment_1166 asemeComment
highlight default link asemeComment_1168 asemeComment
highlight default link asemeComment_1171 asemeComment
highlight default link asemeComment_1173 asemeComment
highlight default link asemeComment_1175 asemeComment
highlight default link asemeComment_1178 asemeComment
highlight default link asemeComment_119 asemeComment
highlight default link asemeComment_1203 asemeComment
highlight default link asemeComment_1206 asemeComment
highlight default link asemeComment_1208 asemeComment
highlight default link asemeComment_1210 asemeComment
highlight default link asemeComment_1212 asemeComment
highlight default link asemeComment_1215 asemeComment
highlight default link asemeComment_1218 asemeComment
highlight default link asemeComment_1219 asemeComment
highlight default link asemeComment_122 asemeComment
highlight default link asemeComment_1222 asemeComment
highlight default link asemeComment_1224 asemeComment
highlight default link asemeComment_1226 asemeComment
highlight default link asemeComment_1229 asemeComment
highlight default link asemeComment_124 asemeComment
highlight default link asemeComment_1252 asemeComment
highlight default link asemeComment_1254 asemeComment
highlight default link asemeComment_1256 asemeComment
highlight default link asemeComment_1258 asemeComment
highlight default link asemeComment_126 asemeComment
highlight default link asemeComment_1260 asemeComment
highlight default link asemeComment_1262 asemeComment
highlight default link asemeComment_1264 asemeComment
highlight default link asemeComment_1267 asemeComment
highlight default link asemeComment_1269 asemeComment
highlight default link asemeComment_1272 asemeComment
highlight default link asemeComment_1275 asemeComment
highlight default link asemeComment_1278 asemeComment
highlight default link asemeComment_1284 asemeComment
highlight default link asemeComment_1287 asemeComment
highlight default link asemeComment_129 asemeComment
highlight default link asemeComment_1313 asemeComment
highlight default link asemeComment_1316 asemeComment
highlight default link asemeComment_132 asemeComment
highlight default link asemeComment_1324 asemeComment
highlight default link asemeComment_1327 asemeComment
highlight default link asemeComment_137 asemeComment
highlight default link asemeComment_141 asemeComment
highlight default link asemeComment_146 asemeComment
highlight default link asemeComment_148 asemeComment
highlight default link asemeComment_150 asemeComment
highlight default link asemeComment_152 asemeComment
highlight default link asemeComment_155 asemeComment
highlight default link asemeComment_157 asemeComment
highlight default link asemeComment_160 asemeComment
highlight default link asemeComment_162 asemeComment
highlight default link asemeComment_165 asemeComment
highlight default link asemeComment_168 asemeComment
highlight default link asemeComment_171 asemeComment
highlight default link asemeComment_174 asemeComment
highlight default link asemeComment_178 asemeComment
highlight default link asemeComment_182 asemeComment
highlight default link asemeComment_185 asemeComment
highlight default link asemeComment_187 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_191 asemeComment
highlight default link asemeComment_193 asemeComment
highlight default link asemeComment_196 asemeComment
highlight default link asemeComment_199 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_204 asemeComment
highlight default link asemeComment_207 asemeComment
highlight default link asemeComment_210 asemeComment
highlight default link asemeComment_213 asemeComment
highlight default link asemeComment_215 asemeComment
highlight default link asemeComment_218 asemeComment
highlight default link asemeComment_221 asemeComment
highlight default link asemeComment_225 asemeComment
highlight default link asemeComment_227 asemeComment
highlight default link asemeComment_229 asemeComment
highlight default link asemeComment_232 asemeComment
highlight default link asemeComment_235 asemeComment
highlight default link asemeComment_238 asemeComment
highlight default link asemeComment_243 asemeComment
highlight default link asemeComment_246 asemeComment
highlight default link asemeComment_248 asemeComment
highlight default link asemeComment_250 asemeComment
highlight default link asemeComment_253 asemeComment
highlight default link asemeComment_257 asemeComment
highlight default link asemeComment_258 asemeComment
highlight default link asemeComment_261 asemeComment
highlight default link asemeComment_263 asemeComment
highlight default link asemeComment_265 asemeComment
highlight default link asemeComment_268 asemeComment
highlight default link asemeComment_291 asemeComment
highlight default link asemeComment_293 asemeComment
highlight default link asemeComment_295 asemeComment
highlight default link asemeComment_297 asemeComment
highlight default link asemeComment_298 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_303 asemeComment
highlight default link asemeComment_326 asemeComment
highlight default link asemeComment_330 asemeComment
highlight default link asemeComment_332 asemeComment
highlight default link asemeComment_335 asemeComment
highlight default link asemeComment_337 asemeComment
highlight default link asemeComment_340 asemeComment
highlight default link asemeComment_344 asemeComment
highlight default link asemeComment_346 asemeComment
highlight default link asemeComment_350 asemeComment
highlight default link asemeComment_352 asemeComment
highlight default link asemeComment_354 asemeComment
highlight default link asemeComment_356 asemeComment
highlight default link asemeComment_359 asemeComment
highlight default link asemeComment_363 asemeComment
highlight default link asemeComment_365 asemeComment
highlight default link asemeComment_368 asemeComment
highlight default link asemeComment_370 asemeComment
highlight default link asemeComment_375 asemeComment
highlight default link asemeComment_378 asemeComment
highlight default link asemeComment_380 asemeComment
highlight default link asemeComment_383 asemeComment
highlight default link asemeComment_385 asemeComment
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_39 asemeComment
highlight default link asemeComment_390 asemeComment
highlight default link asemeComment_415 asemeComment
highlight default link asemeComment_419 asemeComment
highlight default link asemeComment_42 asemeComment
highlight default link asemeComment_421 asemeComment
highlight default link asemeComment_423 asemeComment
highlight default link asemeComment_425 asemeComment
highlight default link asemeComment_427 asemeComment
highlight default link asemeComment_429 asemeComment
highlight default link asemeComment_432 asemeComment
highlight default link asemeComment_436 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_44 asemeComment
highlight default link asemeComment_440 asemeComment
highlight default link asemeComment_442 asemeComment
highlight default link asemeComment_444 asemeComment
highlight default link asemeComment_447 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_472 asemeComment
highlight default link asemeComment_474 asemeComment
highlight default link asemeComment_480 asemeComment
highlight default link asemeComment_482 asemeComment
highlight default link asemeComment_484 asemeComment
highlight default link asemeComment_487 asemeComment
highlight default link asemeComment_489 asemeComment
highlight default link asemeComment_49 asemeComment
highlight default link asemeComment_491 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_496 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_500 asemeComment
highlight default link asemeComment_502 asemeComment
highlight default link asemeComment_505 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_510 asemeComment
highlight default link asemeComment_512 asemeComment
highlight default link asemeComment_514 asemeComment
highlight default link asemeComment_516 asemeComment
highlight default link asemeComment_519 asemeComment
highlight default link asemeComment_522 asemeComment
highlight default link asemeComment_524 asemeComment
highlight default link asemeComment_526 asemeComment
highlight default link asemeComment_528 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_535 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_550 asemeComment
highlight default link asemeComment_553 asemeComment
highlight default link asemeComment_555 asemeComment
highlight default link asemeComment_558 asemeComment
highlight default link asemeComment_560 asemeComment
highlight default link asemeComment_564 asemeComment
highlight default link asemeComment_567 asemeComment
highlight default link asemeComment_570 asemeComment
highlight default link asemeComment_573 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_582 asemeComment
highlight default link asemeComment_588 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_594 asemeComment
highlight default link asemeComment_596 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_602 asemeComment
highlight default link asemeComment_605 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_609 asemeComment
highlight default link asemeComment_612 asemeComment
highlight default link asemeComment_641 asemeComment
highlight default link asemeComment_644 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_648 asemeComment
highlight default link asemeComment_651 asemeComment
highlight default link asemeComment_674 asemeComment
highlight default link asemeComment_676 asemeComment
highlight default link asemeComment_678 asemeComment
highlight default link asemeComment_683 asemeComment
highlight default link asemeComment_686 asemeComment
highlight default link asemeComment_689 asemeComment
highlight default link asemeComment_692 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_697 asemeComment
highlight default link asemeComment_7 asemeComment
highlight default link asemeComment_700 asemeComment
highlight default link asemeComment_702 asemeComment
highlight default link asemeComment_704 asemeComment
highlight default link asemeComment_706 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_712 asemeComment
highlight default link asemeComment_713 asemeComment
highlight default link asemeComment_716 asemeComment
highlight default link asemeComment_718 asemeComment
highlight default link asemeComment_72 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_723 asemeComment
highlight default link asemeComment_74 asemeComment
highlight default link asemeComment_746 asemeComment
highlight default link asemeComment_748 asemeComment
highlight default link asemeComment_750 asemeComment
highlight default link asemeComment_752 asemeComment
highlight default link asemeComment_753 asemeComment
highlight default link asemeComment_756 asemeComment
highlight default link asemeComment_758 asemeComment
highlight default link asemeComment_76 asemeComment
highlight default link asemeComment_78 asemeComment
highlight default link asemeComment_781 asemeComment
highlight default link asemeComment_785 asemeComment
highlight default link asemeComment_787 asemeComment
highlight default link asemeComment_790 asemeComment
highlight default link asemeComment_792 asemeComment
highlight default link asemeComment_795 asemeComment
highlight default link asemeComment_799 asemeComment
highlight default link asemeComment_801 asemeComment
highlight default link asemeComment_805 asemeComment
highlight default link asemeComment_807 asemeComment
highlight default link asemeComment_809 asemeComment
highlight default link asemeComment_811 asemeComment
highlight default link asemeComment_813 asemeComment
highlight default link asemeComment_816 asemeComment
highlight default link asemeComment_820 asemeComment
highlight default link asemeComment_823 asemeComment
highlight default link asemeComment_825 asemeComment
highlight default link asemeComment_827 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_830 asemeComment
highlight default link asemeComment_834 asemeComment
highlight default link asemeComment_836 asemeComment
highlight default link asemeComment_839 asemeComment
highlight default link asemeComment_841 asemeComment
highlight default link asemeComment_846 asemeComment
highlight default link asemeComment_849 asemeComment
highlight default link asemeComment_851 asemeComment
highlight default link asemeComment_854 asemeComment
highlight default link asemeComment_856 asemeComment
highlight default link asemeComment_858 asemeComment
highlight default link asemeComment_86 asemeComment
highlight default link asemeComment_861 asemeComment
highlight default link asemeComment_88 asemeComment
highlight default link asemeComment_886 asemeComment
highlight default link asemeComment_889 asemeComment
highlight default link asemeComment_891 asemeComment
highlight default link asemeComment_893 asemeComment
highlight default link asemeComment_895 asemeComment
highlight default link asemeComment_899 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_90 asemeComment
highlight default link asemeComment_902 asemeComment
highlight default link asemeComment_905 asemeComment
highlight default link asemeComment_915 asemeComment
highlight default link asemeComment_917 asemeComment
highlight default link asemeComment_919 asemeComment
highlight default link asemeComment_922 asemeComment
highlight default link asemeComment_925 asemeComment
highlight default link asemeComment_928 asemeComment
highlight default link asemeComment_931 asemeComment
highlight default link asemeComment_934 asemeComment
highlight default link asemeComment_937 asemeComment
highlight default link asemeComment_94 asemeComment
highlight default link asemeComment_940 asemeComment
highlight default link asemeComment_943 asemeComment
highlight default link asemeComment_946 asemeComment
highlight default link asemeComment_949 asemeComment
highlight default link asemeComment_956 asemeComment
highlight default link asemeComment_958 asemeComment
highlight default link asemeComment_960 asemeComment
highlight default link asemeComment_964 asemeComment
highlight default link asemeComment_966 asemeComment
highlight default link asemeComment_969 asemeComment
highlight default link asemeComment_974 asemeComment
highlight default link asemeComment_978 asemeComment
highlight default link asemeComment_984 asemeComment
highlight default link asemeComment_986 asemeComment
highlight default link asemeComment_988 asemeComment
highlight default link asemeComment_99 asemeComment
highlight default link asemeComment_991 asemeComment
highlight default link asemeComment_994 asemeComment
highlight default link asemeComment_997 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_101 asemeDeclaration
highlight default link asemeDeclaration_1036 asemeDeclaration
highlight default link asemeDeclaration_1039 asemeDeclaration
highlight default link asemeDeclaration_1045 asemeDeclaration
highlight default link asemeDeclaration_1064 asemeDeclaration
highlight default link asemeDeclaration_1071 asemeDeclaration
highlight default link asemeDeclaration_1074 asemeDeclaration
highlight default link asemeDeclaration_1098 asemeDeclaration
highlight default link asemeDeclaration_111 asemeDeclaration
highlight default link asemeDeclaration_1141 asemeDeclaration
highlight default link asemeDeclaration_12 asemeDeclaration
highlight default link asemeDeclaration_1202 asemeDeclaration
highlight default link asemeDeclaration_1207 asemeDeclaration
highlight default link asemeDeclaration_1209 asemeDeclaration
highlight default link asemeDeclaration_1211 asemeDeclaration
highlight default link asemeDeclaration_1217 asemeDeclaration
highlight default link asemeDeclaration_1286 asemeDeclaration
highlight default link asemeDeclaration_1315 asemeDeclaration
highlight default link asemeDeclaration_1326 asemeDeclaration
highlight default link asemeDeclaration_140 asemeDeclaration
highlight default link asemeDeclaration_145 asemeDeclaration
highlight default link asemeDeclaration_186 asemeDeclaration
highlight default link asemeDeclaration_203 asemeDeclaration
highlight default link asemeDeclaration_209 asemeDeclaration
highlight default link asemeDeclaration_212 asemeDeclaration
highlight default link asemeDeclaration_224 asemeDeclaration
highlight default link asemeDeclaration_242 asemeDeclaration
highlight default link asemeDeclaration_245 asemeDeclaration
highlight default link asemeDeclaration_256 asemeDeclaration
highlight default link asemeDeclaration_353 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_414 asemeDeclaration
highlight default link asemeDeclaration_422 asemeDeclaration
highlight default link asemeDeclaration_483 asemeDeclaration
highlight default link asemeDeclaration_488 asemeDeclaration
highlight default link asemeDeclaration_509 asemeDeclaration
highlight default link asemeDeclaration_523 asemeDeclaration
highlight default link asemeDeclaration_549 asemeDeclaration
highlight default link asemeDeclaration_552 asemeDeclaration
highlight default link asemeDeclaration_585 asemeDeclaration
highlight default link asemeDeclaration_589 asemeDeclaration
highlight default link asemeDeclaration_640 asemeDeclaration
highlight default link asemeDeclaration_693 asemeDeclaration
highlight default link asemeDeclaration_699 asemeDeclaration
highlight default link asemeDeclaration_711 asemeDeclaration
highlight default link asemeDeclaration_73 asemeDeclaration
highlight default link asemeDeclaration_808 asemeDeclaration
highlight default link asemeDeclaration_824 asemeDeclaration
highlight default link asemeDeclaration_85 asemeDeclaration
highlight default link asemeDeclaration_885 asemeDeclaration
highlight default link asemeDeclaration_890 asemeDeclaration
highlight default link asemeDeclaration_914 asemeDeclaration
highlight default link asemeDeclaration_983 asemeDeclaration
highlight default link asemeLogic_1121 asemeLogic
highlight default link asemeLogic_1182 asemeLogic
highlight default link asemeLogic_1233 asemeLogic
highlight default link asemeLogic_16 asemeLogic
highlight default link asemeLogic_272 asemeLogic
highlight default link asemeLogic_307 asemeLogic
highlight default link asemeLogic_394 asemeLogic
highlight default link asemeLogic_451 asemeLogic
highlight default link asemeLogic_53 asemeLogic
highlight default link asemeLogic_616 asemeLogic
highlight default link asemeLogic_655 asemeLogic
highlight default link asemeLogic_727 asemeLogic
highlight default link asemeLogic_762 asemeLogic
highlight default link asemeLogic_865 asemeLogic
highlight default link asemeName_103 asemeName
highlight default link asemeName_1034 asemeName
highlight default link asemeName_1080 asemeName
highlight default link asemeName_1084 asemeName
highlight default link asemeName_1090 asemeName
highlight default link asemeName_1092 asemeName
highlight default link asemeName_1200 asemeName
highlight default link asemeName_1201 asemeName
highlight default link asemeName_1205 asemeName
highlight default link asemeName_1251 asemeName
highlight default link asemeName_1271 asemeName
highlight default link asemeName_1273 asemeName
highlight default link asemeName_1281 asemeName
highlight default link asemeName_166 asemeName
highlight default link asemeName_176 asemeName
highlight default link asemeName_181 asemeName
highlight default link asemeName_184 asemeName
highlight default link asemeName_201 asemeName
highlight default link asemeName_202 asemeName
highlight default link asemeName_240 asemeName
highlight default link asemeName_241 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_412 asemeName
highlight default link asemeName_413 asemeName
highlight default link asemeName_420 asemeName
highlight default link asemeName_473 asemeName
highlight default link asemeName_481 asemeName
highlight default link asemeName_486 asemeName
highlight default link asemeName_525 asemeName
highlight default link asemeName_533 asemeName
highlight default link asemeName_545 asemeName
highlight default link asemeName_565 asemeName
highlight default link asemeName_577 asemeName
highlight default link asemeName_584 asemeName
highlight default link asemeName_587 asemeName
highlight default link asemeName_71 asemeName
highlight default link asemeName_80 asemeName
highlight default link asemeName_819 asemeName
highlight default link asemeName_822 asemeName
highlight default link asemeName_883 asemeName
highlight default link asemeName_884 asemeName
highlight default link asemeName_888 asemeName
highlight default link asemeName_892 asemeName
highlight default link asemeName_900 asemeName
highlight default link asemeName_912 asemeName
highlight default link asemeName_92 asemeName
highlight default link asemeName_957 asemeName
highlight default link asemeName_96 asemeName
highlight default link asemeName_965 asemeName
highlight default link asemeName_97 asemeName
highlight default link asemeName_981 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1010 asemeNumber
highlight default link asemeNumber_1088 asemeNumber
highlight default link asemeNumber_1096 asemeNumber
highlight default link asemeNumber_1101 asemeNumber
highlight default link asemeNumber_1105 asemeNumber
highlight default link asemeNumber_1119 asemeNumber
highlight default link asemeNumber_1139 asemeNumber
highlight default link asemeNumber_1150 asemeNumber
highlight default link asemeNumber_1154 asemeNumber
highlight default link asemeNumber_1157 asemeNumber
highlight default link asemeNumber_1164 asemeNumber
highlight default link asemeNumber_117 asemeNumber
highlight default link asemeNumber_1180 asemeNumber
highlight default link asemeNumber_120 asemeNumber
highlight default link asemeNumber_1231 asemeNumber
highlight default link asemeNumber_1257 asemeNumber
highlight default link asemeNumber_1261 asemeNumber
highlight default link asemeNumber_1266 asemeNumber
highlight default link asemeNumber_127 asemeNumber
highlight default link asemeNumber_1289 asemeNumber
highlight default link asemeNumber_1295 asemeNumber
highlight default link asemeNumber_130 asemeNumber
highlight default link asemeNumber_1301 asemeNumber
highlight default link asemeNumber_1307 asemeNumber
highlight default link asemeNumber_1318 asemeNumber
highlight default link asemeNumber_1330 asemeNumber
highlight default link asemeNumber_14 asemeNumber
highlight default link asemeNumber_247 asemeNumber
highlight default link asemeNumber_251 asemeNumber
highlight default link asemeNumber_270 asemeNumber
highlight default link asemeNumber_305 asemeNumber
highlight default link asemeNumber_35 asemeNumber
highlight default link asemeNumber_362 asemeNumber
highlight default link asemeNumber_366 asemeNumber
highlight default link asemeNumber_369 asemeNumber
highlight default link asemeNumber_376 asemeNumber
highlight default link asemeNumber_392 asemeNumber
highlight default link asemeNumber_424 asemeNumber
highlight default link asemeNumber_428 asemeNumber
highlight default link asemeNumber_430 asemeNumber
highlight default link asemeNumber_449 asemeNumber
highlight default link asemeNumber_51 asemeNumber
highlight default link asemeNumber_539 asemeNumber
highlight default link asemeNumber_541 asemeNumber
highlight default link asemeNumber_556 asemeNumber
highlight default link asemeNumber_562 asemeNumber
highlight default link asemeNumber_571 asemeNumber
highlight default link asemeNumber_595 asemeNumber
highlight default link asemeNumber_599 asemeNumber
highlight default link asemeNumber_614 asemeNumber
highlight default link asemeNumber_635 asemeNumber
highlight default link asemeNumber_637 asemeNumber
highlight default link asemeNumber_653 asemeNumber
highlight default link asemeNumber_673 asemeNumber
highlight default link asemeNumber_677 asemeNumber
highlight default link asemeNumber_725 asemeNumber
highlight default link asemeNumber_75 asemeNumber
highlight default link asemeNumber_760 asemeNumber
highlight default link asemeNumber_833 asemeNumber
highlight default link asemeNumber_837 asemeNumber
highlight default link asemeNumber_840 asemeNumber
highlight default link asemeNumber_847 asemeNumber
highlight default link asemeNumber_863 asemeNumber
highlight default link asemeNumber_87 asemeNumber
highlight default link asemeNumber_906 asemeNumber
highlight default link asemeNumber_908 asemeNumber
highlight default link asemeNumber_923 asemeNumber
highlight default link asemeNumber_926 asemeNumber
highlight default link asemeNumber_929 asemeNumber
highlight default link asemeNumber_941 asemeNumber
highlight default link asemeNumber_992 asemeNumber
highlight default link asemeNumber_995 asemeNumber
highlight default link asemeNumber_998 asemeNumber
highlight default link asemeOperator_1031 asemeOperator
highlight default link asemeOperator_1047 asemeOperator
highlight default link asemeOperator_1049 asemeOperator
highlight default link asemeOperator_1051 asemeOperator
highlight default link asemeOperator_1052 asemeOperator
highlight default link asemeOperator_1053 asemeOperator
highlight default link asemeOperator_1055 asemeOperator
highlight default link asemeOperator_1058 asemeOperator
highlight default link asemeOperator_1059 asemeOperator
highlight default link asemeOperator_1061 asemeOperator
highlight default link asemeOperator_1103 asemeOperator
highlight default link asemeOperator_1136 asemeOperator
highlight default link asemeOperator_1197 asemeOperator
highlight default link asemeOperator_1199 asemeOperator
highlight default link asemeOperator_1204 asemeOperator
highlight default link asemeOperator_1248 asemeOperator
highlight default link asemeOperator_1250 asemeOperator
highlight default link asemeOperator_1270 asemeOperator
highlight default link asemeOperator_1280 asemeOperator
highlight default link asemeOperator_1291 asemeOperator
highlight default link asemeOperator_1297 asemeOperator
highlight default link asemeOperator_1303 asemeOperator
highlight default link asemeOperator_1309 asemeOperator
highlight default link asemeOperator_1320 asemeOperator
highlight default link asemeOperator_149 asemeOperator
highlight default link asemeOperator_159 asemeOperator
highlight default link asemeOperator_173 asemeOperator
highlight default link asemeOperator_287 asemeOperator
highlight default link asemeOperator_289 asemeOperator
highlight default link asemeOperator_31 asemeOperator
highlight default link asemeOperator_322 asemeOperator
highlight default link asemeOperator_333 asemeOperator
highlight default link asemeOperator_341 asemeOperator
highlight default link asemeOperator_409 asemeOperator
highlight default link asemeOperator_411 asemeOperator
highlight default link asemeOperator_466 asemeOperator
highlight default link asemeOperator_468 asemeOperator
highlight default link asemeOperator_485 asemeOperator
highlight default link asemeOperator_542 asemeOperator
highlight default link asemeOperator_544 asemeOperator
highlight default link asemeOperator_581 asemeOperator
highlight default link asemeOperator_586 asemeOperator
highlight default link asemeOperator_591 asemeOperator
highlight default link asemeOperator_593 asemeOperator
highlight default link asemeOperator_600 asemeOperator
highlight default link asemeOperator_631 asemeOperator
highlight default link asemeOperator_638 asemeOperator
highlight default link asemeOperator_670 asemeOperator
highlight default link asemeOperator_675 asemeOperator
highlight default link asemeOperator_68 asemeOperator
highlight default link asemeOperator_680 asemeOperator
highlight default link asemeOperator_681 asemeOperator
highlight default link asemeOperator_682 asemeOperator
highlight default link asemeOperator_684 asemeOperator
highlight default link asemeOperator_687 asemeOperator
highlight default link asemeOperator_688 asemeOperator
highlight default link asemeOperator_690 asemeOperator
highlight default link asemeOperator_70 asemeOperator
highlight default link asemeOperator_742 asemeOperator
highlight default link asemeOperator_744 asemeOperator
highlight default link asemeOperator_77 asemeOperator
highlight default link asemeOperator_777 asemeOperator
highlight default link asemeOperator_788 asemeOperator
highlight default link asemeOperator_796 asemeOperator
highlight default link asemeOperator_812 asemeOperator
highlight default link asemeOperator_880 asemeOperator
highlight default link asemeOperator_882 asemeOperator
highlight default link asemeOperator_887 asemeOperator
highlight default link asemeOperator_89 asemeOperator
highlight default link asemeOperator_909 asemeOperator
highlight default link asemeOperator_911 asemeOperator
highlight default link asemePunctuation_1028 asemePunctuation
highlight default link asemePunctuation_1035 asemePunctuation
highlight default link asemePunctuation_1041 asemePunctuation
highlight default link asemePunctuation_1066 asemePunctuation
highlight default link asemePunctuation_107 asemePunctuation
highlight default link asemePunctuation_1100 asemePunctuation
highlight default link asemePunctuation_1108 asemePunctuation
highlight default link asemePunctuation_1137 asemePunctuation
highlight default link asemePunctuation_1138 asemePunctuation
highlight default link asemePunctuation_1149 asemePunctuation
highlight default link asemePunctuation_1152 asemePunctuation
highlight default link asemePunctuation_1155 asemePunctuation
highlight default link asemePunctuation_1162 asemePunctuation
highlight default link asemePunctuation_1165 asemePunctuation
highlight default link asemePunctuation_1167 asemePunctuation
highlight default link asemePunctuation_1169 asemePunctuation
highlight default link asemePunctuation_1198 asemePunctuation
highlight default link asemePunctuation_1213 asemePunctuation
highlight default link asemePunctuation_1220 asemePunctuation
highlight default link asemePunctuation_1249 asemePunctuation
highlight default link asemePunctuation_1255 asemePunctuation
highlight default link asemePunctuation_1259 asemePunctuation
highlight default link asemePunctuation_1263 asemePunctuation
highlight default link asemePunctuation_1265 asemePunctuation
highlight default link asemePunctuation_1268 asemePunctuation
highlight default link asemePunctuation_1274 asemePunctuation
highlight default link asemePunctuation_1277 asemePunctuation
highlight default link asemePunctuation_1279 asemePunctuation
highlight default link asemePunctuation_1282 asemePunctuation
highlight default link asemePunctuation_1292 asemePunctuation
highlight default link asemePunctuation_1293 asemePunctuation
highlight default link asemePunctuation_1298 asemePunctuation
highlight default link asemePunctuation_1299 asemePunctuation
highlight default link asemePunctuation_1304 asemePunctuation
highlight default link asemePunctuation_1305 asemePunctuation
highlight default link asemePunctuation_1310 asemePunctuation
highlight default link asemePunctuation_1311 asemePunctuation
highlight default link asemePunctuation_1321 asemePunctuation
highlight default link asemePunctuation_1322 asemePunctuation
highlight default link asemePunctuation_1333 asemePunctuation
highlight default link asemePunctuation_136 asemePunctuation
highlight default link asemePunctuation_142 asemePunctuation
highlight default link asemePunctuation_154 asemePunctuation
highlight default link asemePunctuation_156 asemePunctuation
highlight default link asemePunctuation_164 asemePunctuation
highlight default link asemePunctuation_170 asemePunctuation
highlight default link asemePunctuation_175 asemePunctuation
highlight default link asemePunctuation_180 asemePunctuation
highlight default link asemePunctuation_183 asemePunctuation
highlight default link asemePunctuation_198 asemePunctuation
highlight default link asemePunctuation_205 asemePunctuation
highlight default link asemePunctuation_211 asemePunctuation
highlight default link asemePunctuation_217 asemePunctuation
highlight default link asemePunctuation_220 asemePunctuation
highlight default link asemePunctuation_237 asemePunctuation
highlight default link asemePunctuation_244 asemePunctuation
highlight default link asemePunctuation_249 asemePunctuation
highlight default link asemePunctuation_252 asemePunctuation
highlight default link asemePunctuation_254 asemePunctuation
highlight default link asemePunctuation_259 asemePunctuation
highlight default link asemePunctuation_288 asemePunctuation
highlight default link asemePunctuation_299 asemePunctuation
highlight default link asemePunctuation_32 asemePunctuation
highlight default link asemePunctuation_323 asemePunctuation
highlight default link asemePunctuation_329 asemePunctuation
highlight default link asemePunctuation_336 asemePunctuation
highlight default link asemePunctuation_339 asemePunctuation
highlight default link asemePunctuation_343 asemePunctuation
highlight default link asemePunctuation_349 asemePunctuation
highlight default link asemePunctuation_361 asemePunctuation
highlight default link asemePunctuation_364 asemePunctuation
highlight default link asemePunctuation_367 asemePunctuation
highlight default link asemePunctuation_374 asemePunctuation
highlight default link asemePunctuation_377 asemePunctuation
highlight default link asemePunctuation_379 asemePunctuation
highlight default link asemePunctuation_38 asemePunctuation
highlight default link asemePunctuation_381 asemePunctuation
highlight default link asemePunctuation_40 asemePunctuation
highlight default link asemePunctuation_410 asemePunctuation
highlight default link asemePunctuation_418 asemePunctuation
highlight default link asemePunctuation_426 asemePunctuation
highlight default link asemePunctuation_431 asemePunctuation
highlight default link asemePunctuation_435 asemePunctuation
highlight default link asemePunctuation_438 asemePunctuation
highlight default link asemePunctuation_467 asemePunctuation
highlight default link asemePunctuation_471 asemePunctuation
highlight default link asemePunctuation_479 asemePunctuation
highlight default link asemePunctuation_501 asemePunctuation
highlight default link asemePunctuation_515 asemePunctuation
highlight default link asemePunctuation_527 asemePunctuation
highlight default link asemePunctuation_531 asemePunctuation
highlight default link asemePunctuation_534 asemePunctuation
highlight default link asemePunctuation_536 asemePunctuation
highlight default link asemePunctuation_543 asemePunctuation
highlight default link asemePunctuation_546 asemePunctuation
highlight default link asemePunctuation_578 asemePunctuation
highlight default link asemePunctuation_583 asemePunctuation
highlight default link asemePunctuation_603 asemePunctuation
highlight default link asemePunctuation_632 asemePunctuation
highlight default link asemePunctuation_633 asemePunctuation
highlight default link asemePunctuation_639 asemePunctuation
highlight default link asemePunctuation_642 asemePunctuation
highlight default link asemePunctuation_671 asemePunctuation
highlight default link asemePunctuation_672 asemePunctuation
highlight default link asemePunctuation_679 asemePunctuation
highlight default link asemePunctuation_69 asemePunctuation
highlight default link asemePunctuation_695 asemePunctuation
highlight default link asemePunctuation_707 asemePunctuation
highlight default link asemePunctuation_714 asemePunctuation
highlight default link asemePunctuation_743 asemePunctuation
highlight default link asemePunctuation_754 asemePunctuation
highlight default link asemePunctuation_778 asemePunctuation
highlight default link asemePunctuation_784 asemePunctuation
highlight default link asemePunctuation_79 asemePunctuation
highlight default link asemePunctuation_791 asemePunctuation
highlight default link asemePunctuation_794 asemePunctuation
highlight default link asemePunctuation_798 asemePunctuation
highlight default link asemePunctuation_804 asemePunctuation
highlight default link asemePunctuation_81 asemePunctuation
highlight default link asemePunctuation_815 asemePunctuation
highlight default link asemePunctuation_832 asemePunctuation
highlight default link asemePunctuation_835 asemePunctuation
highlight default link asemePunctuation_838 asemePunctuation
highlight default link asemePunctuation_845 asemePunctuation
highlight default link asemePunctuation_848 asemePunctuation
highlight default link asemePunctuation_850 asemePunctuation
highlight default link asemePunctuation_852 asemePunctuation
highlight default link asemePunctuation_881 asemePunctuation
highlight default link asemePunctuation_894 asemePunctuation
highlight default link asemePunctuation_898 asemePunctuation
highlight default link asemePunctuation_901 asemePunctuation
highlight default link asemePunctuation_903 asemePunctuation
highlight default link asemePunctuation_91 asemePunctuation
highlight default link asemePunctuation_910 asemePunctuation
highlight default link asemePunctuation_913 asemePunctuation
highlight default link asemePunctuation_955 asemePunctuation
highlight default link asemePunctuation_959 asemePunctuation
highlight default link asemePunctuation_963 asemePunctuation
highlight default link asemePunctuation_973 asemePunctuation
highlight default link asemePunctuation_977 asemePunctuation
highlight default link asemePunctuation_979 asemePunctuation
highlight default link asemePunctuation_982 asemePunctuation
highlight default link asemeReference_1004 asemeReference
highlight default link asemeReference_1007 asemeReference
highlight default link asemeReference_1013 asemeReference
highlight default link asemeReference_1016 asemeReference
highlight default link asemeReference_1022 asemeReference
highlight default link asemeReference_1025 asemeReference
highlight default link asemeReference_1026 asemeReference
highlight default link asemeReference_1027 asemeReference
highlight default link asemeReference_1033 asemeReference
highlight default link asemeReference_1076 asemeReference
highlight default link asemeReference_11 asemeReference
highlight default link asemeReference_1109 asemeReference
highlight default link asemeReference_1111 asemeReference
highlight default link asemeReference_1115 asemeReference
highlight default link asemeReference_113 asemeReference
highlight default link asemeReference_1135 asemeReference
highlight default link asemeReference_1170 asemeReference
highlight default link asemeReference_1172 asemeReference
highlight default link asemeReference_1176 asemeReference
highlight default link asemeReference_1196 asemeReference
highlight default link asemeReference_1221 asemeReference
highlight default link asemeReference_1223 asemeReference
highlight default link asemeReference_1227 asemeReference
highlight default link asemeReference_123 asemeReference
highlight default link asemeReference_1247 asemeReference
highlight default link asemeReference_1276 asemeReference
highlight default link asemeReference_1290 asemeReference
highlight default link asemeReference_1296 asemeReference
highlight default link asemeReference_1302 asemeReference
highlight default link asemeReference_1308 asemeReference
highlight default link asemeReference_1319 asemeReference
highlight default link asemeReference_1331 asemeReference
highlight default link asemeReference_1332 asemeReference
highlight default link asemeReference_134 asemeReference
highlight default link asemeReference_135 asemeReference
highlight default link asemeReference_138 asemeReference
highlight default link asemeReference_139 asemeReference
highlight default link asemeReference_188 asemeReference
highlight default link asemeReference_194 asemeReference
highlight default link asemeReference_197 asemeReference
highlight default link asemeReference_216 asemeReference
highlight default link asemeReference_222 asemeReference
highlight default link asemeReference_223 asemeReference
highlight default link asemeReference_226 asemeReference
highlight default link asemeReference_230 asemeReference
highlight default link asemeReference_233 asemeReference
highlight default link asemeReference_236 asemeReference
highlight default link asemeReference_260 asemeReference
highlight default link asemeReference_262 asemeReference
highlight default link asemeReference_266 asemeReference
highlight default link asemeReference_286 asemeReference
highlight default link asemeReference_290 asemeReference
highlight default link asemeReference_294 asemeReference
highlight default link asemeReference_30 asemeReference
highlight default link asemeReference_300 asemeReference
highlight default link asemeReference_302 asemeReference
highlight default link asemeReference_321 asemeReference
highlight default link asemeReference_328 asemeReference
highlight default link asemeReference_331 asemeReference
highlight default link asemeReference_334 asemeReference
highlight default link asemeReference_338 asemeReference
highlight default link asemeReference_342 asemeReference
highlight default link asemeReference_345 asemeReference
highlight default link asemeReference_347 asemeReference
highlight default link asemeReference_348 asemeReference
highlight default link asemeReference_351 asemeReference
highlight default link asemeReference_36 asemeReference
highlight default link asemeReference_37 asemeReference
highlight default link asemeReference_382 asemeReference
highlight default link asemeReference_384 asemeReference
highlight default link asemeReference_388 asemeReference
highlight default link asemeReference_408 asemeReference
highlight default link asemeReference_41 asemeReference
highlight default link asemeReference_43 asemeReference
highlight default link asemeReference_439 asemeReference
highlight default link asemeReference_441 asemeReference
highlight default link asemeReference_445 asemeReference
highlight default link asemeReference_465 asemeReference
highlight default link asemeReference_47 asemeReference
highlight default link asemeReference_490 asemeReference
highlight default link asemeReference_494 asemeReference
highlight default link asemeReference_498 asemeReference
highlight default link asemeReference_499 asemeReference
highlight default link asemeReference_503 asemeReference
highlight default link asemeReference_504 asemeReference
highlight default link asemeReference_506 asemeReference
highlight default link asemeReference_507 asemeReference
highlight default link asemeReference_511 asemeReference
highlight default link asemeReference_513 asemeReference
highlight default link asemeReference_517 asemeReference
highlight default link asemeReference_518 asemeReference
highlight default link asemeReference_520 asemeReference
highlight default link asemeReference_521 asemeReference
highlight default link asemeReference_540 asemeReference
highlight default link asemeReference_580 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_604 asemeReference
highlight default link asemeReference_606 asemeReference
highlight default link asemeReference_610 asemeReference
highlight default link asemeReference_630 asemeReference
highlight default link asemeReference_636 asemeReference
highlight default link asemeReference_643 asemeReference
highlight default link asemeReference_645 asemeReference
highlight default link asemeReference_649 asemeReference
highlight default link asemeReference_669 asemeReference
highlight default link asemeReference_67 asemeReference
highlight default link asemeReference_705 asemeReference
highlight default link asemeReference_709 asemeReference
highlight default link asemeReference_710 asemeReference
highlight default link asemeReference_715 asemeReference
highlight default link asemeReference_717 asemeReference
highlight default link asemeReference_721 asemeReference
highlight default link asemeReference_741 asemeReference
highlight default link asemeReference_745 asemeReference
highlight default link asemeReference_749 asemeReference
highlight default link asemeReference_755 asemeReference
highlight default link asemeReference_757 asemeReference
highlight default link asemeReference_776 asemeReference
highlight default link asemeReference_783 asemeReference
highlight default link asemeReference_786 asemeReference
highlight default link asemeReference_789 asemeReference
highlight default link asemeReference_793 asemeReference
highlight default link asemeReference_797 asemeReference
highlight default link asemeReference_800 asemeReference
highlight default link asemeReference_802 asemeReference
highlight default link asemeReference_803 asemeReference
highlight default link asemeReference_806 asemeReference
highlight default link asemeReference_810 asemeReference
highlight default link asemeReference_814 asemeReference
highlight default link asemeReference_853 asemeReference
highlight default link asemeReference_855 asemeReference
highlight default link asemeReference_859 asemeReference
highlight default link asemeReference_879 asemeReference
highlight default link asemeReference_907 asemeReference
highlight default link asemeReference_916 asemeReference
highlight default link asemeReference_920 asemeReference
highlight default link asemeReference_935 asemeReference
highlight default link asemeReference_938 asemeReference
highlight default link asemeReference_944 asemeReference
highlight default link asemeReference_947 asemeReference
highlight default link asemeReference_967 asemeReference
highlight default link asemeReference_970 asemeReference
highlight default link asemeReference_971 asemeReference
highlight default link asemeReference_972 asemeReference
highlight default link asemeReference_980 asemeReference
highlight default link asemeReference_985 asemeReference
highlight default link asemeReference_989 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1030 asemeText
highlight default link asemeText_1038 asemeText
highlight default link asemeText_1081 asemeText
highlight default link asemeText_1085 asemeText
highlight default link asemeText_1091 asemeText
highlight default link asemeText_1093 asemeText
highlight default link asemeText_1118 asemeText
highlight default link asemeText_1179 asemeText
highlight default link asemeText_1230 asemeText
highlight default link asemeText_1288 asemeText
highlight default link asemeText_1294 asemeText
highlight default link asemeText_13 asemeText
highlight default link asemeText_1300 asemeText
highlight default link asemeText_1306 asemeText
highlight default link asemeText_1312 asemeText
highlight default link asemeText_1314 asemeText
highlight default link asemeText_1317 asemeText
highlight default link asemeText_1323 asemeText
highlight default link asemeText_1325 asemeText
highlight default link asemeText_1328 asemeText
highlight default link asemeText_1329 asemeText
highlight default link asemeText_147 asemeText
highlight default link asemeText_158 asemeText
highlight default link asemeText_172 asemeText
highlight default link asemeText_200 asemeText
highlight default link asemeText_239 asemeText
highlight default link asemeText_255 asemeText
highlight default link asemeText_269 asemeText
highlight default link asemeText_304 asemeText
highlight default link asemeText_33 asemeText
highlight default link asemeText_34 asemeText
highlight default link asemeText_391 asemeText
highlight default link asemeText_448 asemeText
highlight default link asemeText_50 asemeText
highlight default link asemeText_537 asemeText
highlight default link asemeText_551 asemeText
highlight default link asemeText_613 asemeText
highlight default link asemeText_634 asemeText
highlight default link asemeText_652 asemeText
highlight default link asemeText_724 asemeText
highlight default link asemeText_759 asemeText
highlight default link asemeText_817 asemeText
highlight default link asemeText_818 asemeText
highlight default link asemeText_821 asemeText
highlight default link asemeText_862 asemeText
highlight default link asemeText_904 asemeText
highlight default link asemeTruth_1120 asemeTruth
highlight default link asemeTruth_1181 asemeTruth
highlight default link asemeTruth_1232 asemeTruth
highlight default link asemeTruth_15 asemeTruth
highlight default link asemeTruth_271 asemeTruth
highlight default link asemeTruth_306 asemeTruth
highlight default link asemeTruth_393 asemeTruth
highlight default link asemeTruth_450 asemeTruth
highlight default link asemeTruth_52 asemeTruth
highlight default link asemeTruth_615 asemeTruth
highlight default link asemeTruth_654 asemeTruth
highlight default link asemeTruth_726 asemeTruth
highlight default link asemeTruth_761 asemeTruth
highlight default link asemeTruth_864 asemeTruth
highlight default link asemeType_100 asemeType
highlight default link asemeType_106 asemeType
highlight default link asemeType_1145 asemeType
highlight default link asemeType_1161 asemeType
highlight default link asemeType_153 asemeType
highlight default link asemeType_163 asemeType
highlight default link asemeType_169 asemeType
highlight default link asemeType_179 asemeType
highlight default link asemeType_357 asemeType
highlight default link asemeType_373 asemeType
highlight default link asemeType_417 asemeType
highlight default link asemeType_434 asemeType
highlight default link asemeType_470 asemeType
highlight default link asemeType_476 asemeType
highlight default link asemeType_478 asemeType
highlight default link asemeType_530 asemeType
highlight default link asemeType_828 asemeType
highlight default link asemeType_844 asemeType
highlight default link asemeType_897 asemeType
highlight default link asemeType_95 asemeType
highlight default link asemeType_954 asemeType
highlight default link asemeType_962 asemeType
highlight default link asemeType_976 asemeType
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
