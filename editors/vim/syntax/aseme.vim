" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1287 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1286 /\v\w+/
syntax match asemeNumber_1285 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1284 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1283 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1288 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1283,asemeText_1284,asemeNumber_1285,asemeReference_1286,asemeReference_1287,asemePunctuation_1288,asemeComment
syntax match asemeReference_34 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_33 /\v\w+/ contained
syntax match asemeNumber_32 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_31 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_30 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_35 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_70,asemeDeclaration_82,asemeDeclaration_108,asemeDeclaration_138,asemeDeclaration_179,asemeDeclaration_205,asemeDeclaration_238,asemeDeclaration_673,asemeDeclaration_1034,asemeDeclaration_1037,asemeDeclaration_1172,asemeDeclaration_1241,asemeDeclaration_1270,asemeDeclaration_1281,asemeText_1283,asemeText_1284,asemeNumber_1285,asemeReference_1286,asemeReference_1287,asemePunctuation_1288,asemeComment
syntax match asemeDeclaration_1281 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1280,asemeComment_1282 skipwhite skipempty
syntax region asemeComment_1282 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1280,asemeComment_1282 skipwhite skipempty
syntax match asemeComment_1282 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1280,asemeComment_1282 skipwhite skipempty
syntax match asemeText_1280 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1279 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1277,asemeText_1278
syntax match asemeText_1278 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1279 skipwhite skipempty
syntax region asemeComment_1279 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1279 skipwhite skipempty
syntax match asemeComment_1279 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1279 skipwhite skipempty
syntax region asemePunctuation_1277 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_1260,asemeText_1272,asemeNumber_1273,asemeReference_1274,asemeOperator_1275,asemePunctuation_1276,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1276 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1275 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1274 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1273 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1272 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1270 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_1269,asemeComment_1271 skipwhite skipempty
syntax region asemeComment_1271 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1269,asemeComment_1271 skipwhite skipempty
syntax match asemeComment_1271 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1269,asemeComment_1271 skipwhite skipempty
syntax match asemeText_1269 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1268 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_1266,asemeText_1267
syntax match asemeText_1267 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1268 skipwhite skipempty
syntax region asemeComment_1268 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1268 skipwhite skipempty
syntax match asemeComment_1268 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1268 skipwhite skipempty
syntax region asemePunctuation_1266 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_1260,asemeText_1261,asemeNumber_1262,asemeReference_1263,asemeOperator_1264,asemePunctuation_1265,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1265 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1264 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1263 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1262 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1261 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1260 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_1254,asemeText_1255,asemeNumber_1256,asemeReference_1257,asemeOperator_1258,asemePunctuation_1259,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1259 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1258 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1257 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1256 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1255 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1254 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_1248,asemeText_1249,asemeNumber_1250,asemeReference_1251,asemeOperator_1252,asemePunctuation_1253,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1253 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1252 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1251 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1250 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1249 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1248 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_1243,asemeNumber_1244,asemeReference_1245,asemeOperator_1246,asemePunctuation_1247,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1247 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1246 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1245 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1244 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1243 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1241 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_1240,asemeComment_1242 skipwhite skipempty
syntax region asemeComment_1242 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1240,asemeComment_1242 skipwhite skipempty
syntax match asemeComment_1242 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1240,asemeComment_1242 skipwhite skipempty
syntax match asemeBlock_1240 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1239 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_1237,asemeBlock_1238
syntax match asemeBlock_1238 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1239 skipwhite skipempty
syntax region asemeComment_1239 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1239 skipwhite skipempty
syntax match asemeComment_1239 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1239 skipwhite skipempty
syntax region asemePunctuation_1237 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_1236,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_1236 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_1208,asemePunctuation_1218,asemePunctuation_1223,asemePunctuation_1229,asemePunctuation_1232,asemePunctuation_1234,asemeOperator_1235
syntax match asemeOperator_1235 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemePunctuation_1234 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax match asemePunctuation_1232 /\v\:/ contained nextgroup=asemeReference_1231,asemeComment_1233 skipwhite skipempty
syntax region asemeComment_1233 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1231,asemeComment_1233 skipwhite skipempty
syntax match asemeComment_1233 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1231,asemeComment_1233 skipwhite skipempty
syntax match asemeReference_1231 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax match asemePunctuation_1229 /\v\,/ contained nextgroup=asemeName_1226,asemeName_1228,asemeComment_1230 skipwhite skipempty
syntax region asemeComment_1230 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1226,asemeName_1228,asemeComment_1230 skipwhite skipempty
syntax match asemeComment_1230 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1226,asemeName_1228,asemeComment_1230 skipwhite skipempty
syntax match asemeName_1228 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax match asemeName_1226 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1225,asemeComment_1227 skipwhite skipempty
syntax region asemeComment_1227 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1225,asemeComment_1227 skipwhite skipempty
syntax match asemeComment_1227 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1225,asemeComment_1227 skipwhite skipempty
syntax match asemeOperator_1225 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemePunctuation_1223 /\v\.\./ contained nextgroup=asemeNumber_1221,asemeComment_1224 skipwhite skipempty
syntax region asemeComment_1224 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1221,asemeComment_1224 skipwhite skipempty
syntax match asemeComment_1224 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1221,asemeComment_1224 skipwhite skipempty
syntax match asemeNumber_1221 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax region asemeComment_1222 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax match asemeComment_1222 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1220,asemeComment_1222 skipwhite skipempty
syntax match asemePunctuation_1220 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax match asemePunctuation_1218 /\v\[/ contained nextgroup=asemeNumber_1216,asemeComment_1219 skipwhite skipempty
syntax region asemeComment_1219 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1216,asemeComment_1219 skipwhite skipempty
syntax match asemeComment_1219 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1216,asemeComment_1219 skipwhite skipempty
syntax match asemeNumber_1216 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1214,asemeComment_1217 skipwhite skipempty
syntax region asemeComment_1217 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1214,asemeComment_1217 skipwhite skipempty
syntax match asemeComment_1217 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1214,asemeComment_1217 skipwhite skipempty
syntax match asemePunctuation_1214 /\v\.\./ contained nextgroup=asemeNumber_1212,asemeComment_1215 skipwhite skipempty
syntax region asemeComment_1215 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1212,asemeComment_1215 skipwhite skipempty
syntax match asemeComment_1215 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1212,asemeComment_1215 skipwhite skipempty
syntax match asemeNumber_1212 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1210,asemeComment_1213 skipwhite skipempty
syntax region asemeComment_1213 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1210,asemeComment_1213 skipwhite skipempty
syntax match asemeComment_1213 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1210,asemeComment_1213 skipwhite skipempty
syntax match asemePunctuation_1210 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax region asemeComment_1211 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax match asemeComment_1211 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1211 skipwhite skipempty
syntax match asemeClause_1208 /\vwith%(<|>)/ contained nextgroup=asemeName_1206,asemeComment_1209 skipwhite skipempty
syntax region asemeComment_1209 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1206,asemeComment_1209 skipwhite skipempty
syntax match asemeComment_1209 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1206,asemeComment_1209 skipwhite skipempty
syntax match asemeName_1206 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1205,asemeComment_1207 skipwhite skipempty
syntax region asemeComment_1207 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1205,asemeComment_1207 skipwhite skipempty
syntax match asemeComment_1207 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1205,asemeComment_1207 skipwhite skipempty
syntax match asemeOperator_1205 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeDeclaration_1172 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_1171,asemeComment_1173 skipwhite skipempty
syntax region asemeComment_1173 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1171,asemeComment_1173 skipwhite skipempty
syntax match asemeComment_1173 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1171,asemeComment_1173 skipwhite skipempty
syntax match asemeBlock_1171 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1170 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_1168,asemeBlock_1169
syntax match asemeBlock_1169 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1170 skipwhite skipempty
syntax region asemeComment_1170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1170 skipwhite skipempty
syntax match asemeComment_1170 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1170 skipwhite skipempty
syntax region asemePunctuation_1168 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_1061,asemeNumber_1068,asemeDeclaration_1104,asemeDeclaration_1157,asemeDeclaration_1162,asemeDeclaration_1164,asemeDeclaration_1166,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_1166 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1167 skipwhite skipempty
syntax region asemeComment_1167 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1167 skipwhite skipempty
syntax match asemeComment_1167 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1167 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_998
syntax match asemeDeclaration_1164 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1165 skipwhite skipempty
syntax region asemeComment_1165 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1165 skipwhite skipempty
syntax match asemeComment_1165 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1165 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_945
syntax match asemeDeclaration_1162 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_1160,asemeComment_1163 skipwhite skipempty
syntax region asemeComment_1163 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1160,asemeComment_1163 skipwhite skipempty
syntax match asemeComment_1163 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1160,asemeComment_1163 skipwhite skipempty
syntax match asemeName_1160 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1159,asemeComment_1161 skipwhite skipempty
syntax region asemeComment_1161 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1159,asemeComment_1161 skipwhite skipempty
syntax match asemeComment_1161 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1159,asemeComment_1161 skipwhite skipempty
syntax match asemeOperator_1159 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_1157 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_1155,asemeComment_1158 skipwhite skipempty
syntax region asemeComment_1158 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1155,asemeComment_1158 skipwhite skipempty
syntax match asemeComment_1158 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1155,asemeComment_1158 skipwhite skipempty
syntax match asemeName_1155 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_1153,asemeComment_1156 skipwhite skipempty
syntax region asemeComment_1156 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1153,asemeComment_1156 skipwhite skipempty
syntax match asemeComment_1156 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1153,asemeComment_1156 skipwhite skipempty
syntax match asemePunctuation_1153 /\v\:/ contained nextgroup=asemeBuiltIn_1151,asemeType_1152,asemeComment_1154 skipwhite skipempty
syntax region asemeComment_1154 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1151,asemeType_1152,asemeComment_1154 skipwhite skipempty
syntax match asemeComment_1154 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1151,asemeType_1152,asemeComment_1154 skipwhite skipempty
syntax match asemeType_1152 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeBuiltIn_1151 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_1109,asemeOperator_1142,asemeName_1147,asemeBuiltIn_1149,asemeType_1150
syntax match asemeType_1150 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeBuiltIn_1149 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeName_1147 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_1145,asemeComment_1148 skipwhite skipempty
syntax region asemeComment_1148 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1145,asemeComment_1148 skipwhite skipempty
syntax match asemeComment_1148 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1145,asemeComment_1148 skipwhite skipempty
syntax match asemePunctuation_1145 /\v\:/ contained nextgroup=asemeBuiltIn_1143,asemeType_1144,asemeComment_1146 skipwhite skipempty
syntax region asemeComment_1146 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1143,asemeType_1144,asemeComment_1146 skipwhite skipempty
syntax match asemeComment_1146 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1143,asemeType_1144,asemeComment_1146 skipwhite skipempty
syntax match asemeType_1144 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeBuiltIn_1143 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeOperator_1142 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemePunctuation_1109 /\v\:/ contained nextgroup=asemeBuiltIn_1106,asemeType_1108,asemeComment_1110 skipwhite skipempty
syntax region asemeComment_1110 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1106,asemeType_1108,asemeComment_1110 skipwhite skipempty
syntax match asemeComment_1110 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1106,asemeType_1108,asemeComment_1110 skipwhite skipempty
syntax match asemeType_1108 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeBuiltIn_1106 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax region asemeComment_1107 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeComment_1107 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeDeclaration_1104 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_1102,asemeComment_1105 skipwhite skipempty
syntax region asemeComment_1105 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1102,asemeComment_1105 skipwhite skipempty
syntax match asemeComment_1105 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1102,asemeComment_1105 skipwhite skipempty
syntax match asemeNumber_1102 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1101,asemeComment_1103 skipwhite skipempty
syntax region asemeComment_1103 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1101,asemeComment_1103 skipwhite skipempty
syntax match asemeComment_1103 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1101,asemeComment_1103 skipwhite skipempty
syntax match asemePunctuation_1101 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeNumber_1068 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_1066,asemeComment_1069 skipwhite skipempty
syntax region asemeComment_1069 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1066,asemeComment_1069 skipwhite skipempty
syntax match asemeComment_1069 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1066,asemeComment_1069 skipwhite skipempty
syntax match asemeOperator_1066 /\v\-\>/ contained nextgroup=asemeNumber_1064,asemeComment_1067 skipwhite skipempty
syntax region asemeComment_1067 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1064,asemeComment_1067 skipwhite skipempty
syntax match asemeComment_1067 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1064,asemeComment_1067 skipwhite skipempty
syntax match asemeNumber_1064 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1063,asemeComment_1065 skipwhite skipempty
syntax region asemeComment_1065 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1063,asemeComment_1065 skipwhite skipempty
syntax match asemeComment_1065 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1063,asemeComment_1065 skipwhite skipempty
syntax match asemePunctuation_1063 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeDeclaration_1061 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_1059,asemeComment_1062 skipwhite skipempty
syntax region asemeComment_1062 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1059,asemeComment_1062 skipwhite skipempty
syntax match asemeComment_1062 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1059,asemeComment_1062 skipwhite skipempty
syntax match asemeNumber_1059 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1057,asemeComment_1060 skipwhite skipempty
syntax region asemeComment_1060 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1057,asemeComment_1060 skipwhite skipempty
syntax match asemeComment_1060 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1057,asemeComment_1060 skipwhite skipempty
syntax match asemeChoice_1057 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1055,asemeText_1056,@asemeChartNodeInBodyOfStatechart,asemeComment_1058 skipwhite skipempty
syntax region asemeComment_1058 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1055,asemeText_1056,@asemeChartNodeInBodyOfStatechart,asemeComment_1058 skipwhite skipempty
syntax match asemeComment_1058 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1055,asemeText_1056,@asemeChartNodeInBodyOfStatechart,asemeComment_1058 skipwhite skipempty
syntax match asemeText_1056 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeName_1055 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_1041,asemeChoice_1045,asemeNumber_1051,asemeName_1053,asemeText_1054
syntax match asemeText_1054 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeName_1053 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeNumber_1051 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_1049,asemeComment_1052 skipwhite skipempty
syntax region asemeComment_1052 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_1049,asemeComment_1052 skipwhite skipempty
syntax match asemeComment_1052 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_1049,asemeComment_1052 skipwhite skipempty
syntax match asemeChoice_1049 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1047,asemeText_1048,@asemeChartNodeInBodyOfStatechart,asemeComment_1050 skipwhite skipempty
syntax region asemeComment_1050 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1047,asemeText_1048,@asemeChartNodeInBodyOfStatechart,asemeComment_1050 skipwhite skipempty
syntax match asemeComment_1050 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1047,asemeText_1048,@asemeChartNodeInBodyOfStatechart,asemeComment_1050 skipwhite skipempty
syntax match asemeText_1048 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeName_1047 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeChoice_1045 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_1043,asemeText_1044,@asemeChartNodeInBodyOfStatechart,asemeComment_1046 skipwhite skipempty
syntax region asemeComment_1046 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1043,asemeText_1044,@asemeChartNodeInBodyOfStatechart,asemeComment_1046 skipwhite skipempty
syntax match asemeComment_1046 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1043,asemeText_1044,@asemeChartNodeInBodyOfStatechart,asemeComment_1046 skipwhite skipempty
syntax match asemeText_1044 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeName_1043 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeClause_1041 /\vactivity%(<|>)/ contained nextgroup=asemeReference_1039,asemeComment_1042 skipwhite skipempty
syntax region asemeComment_1042 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1039,asemeComment_1042 skipwhite skipempty
syntax match asemeComment_1042 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1039,asemeComment_1042 skipwhite skipempty
syntax match asemeReference_1039 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax region asemeComment_1040 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeComment_1040 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_1040 skipwhite skipempty
syntax match asemeDeclaration_1037 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_1036,asemeComment_1038 skipwhite skipempty
syntax region asemeComment_1038 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1036,asemeComment_1038 skipwhite skipempty
syntax match asemeComment_1038 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1036,asemeComment_1038 skipwhite skipempty
syntax match asemeBlock_1036 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_676 skipwhite skipempty
syntax match asemeDeclaration_1034 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_1032,asemeComment_1035 skipwhite skipempty
syntax region asemeComment_1035 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_1032,asemeComment_1035 skipwhite skipempty
syntax match asemeComment_1035 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_1032,asemeComment_1035 skipwhite skipempty
syntax match asemeClause_1032 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_1031,asemeComment_1033 skipwhite skipempty
syntax region asemeComment_1033 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1031,asemeComment_1033 skipwhite skipempty
syntax match asemeComment_1033 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1031,asemeComment_1033 skipwhite skipempty
syntax match asemeBlock_1031 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_676 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_677,asemePunctuation_1029,asemeBlock_1030
syntax match asemeBlock_1030 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_676 skipwhite skipempty
syntax region asemePunctuation_1029 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_685,asemeDeclaration_779,asemeDeclaration_795,asemeDeclaration_848,asemeDeclaration_853,asemeDeclaration_877,asemeDeclaration_946,asemeDeclaration_999,asemeDeclaration_1008,asemeDeclaration_1027,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_1027 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_1025,asemeComment_1028 skipwhite skipempty
syntax region asemeComment_1028 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1025,asemeComment_1028 skipwhite skipempty
syntax match asemeComment_1028 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1025,asemeComment_1028 skipwhite skipempty
syntax match asemeBlock_1025 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1022,asemeOperator_1024,@asemeControlInBodyOfSrm,asemeComment_1026 skipwhite skipempty
syntax region asemeComment_1026 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1022,asemeOperator_1024,@asemeControlInBodyOfSrm,asemeComment_1026 skipwhite skipempty
syntax match asemeComment_1026 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1022,asemeOperator_1024,@asemeControlInBodyOfSrm,asemeComment_1026 skipwhite skipempty
syntax match asemeOperator_1024 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax match asemeOperator_1022 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1021,@asemeControlInBodyOfSrm,asemeComment_1023 skipwhite skipempty
syntax region asemeComment_1023 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1021,@asemeControlInBodyOfSrm,asemeComment_1023 skipwhite skipempty
syntax match asemeComment_1023 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1021,@asemeControlInBodyOfSrm,asemeComment_1023 skipwhite skipempty
syntax match asemeOperator_1021 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemeOperator_1012,asemePunctuation_653,asemeOperator_1014,asemeBlock_1019
syntax match asemeBlock_1019 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_1016,asemeOperator_1018,@asemeControlInBodyOfSrm,asemeComment_1020 skipwhite skipempty
syntax region asemeComment_1020 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1016,asemeOperator_1018,@asemeControlInBodyOfSrm,asemeComment_1020 skipwhite skipempty
syntax match asemeComment_1020 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1016,asemeOperator_1018,@asemeControlInBodyOfSrm,asemeComment_1020 skipwhite skipempty
syntax match asemeOperator_1018 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax match asemeOperator_1016 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1015,@asemeControlInBodyOfSrm,asemeComment_1017 skipwhite skipempty
syntax region asemeComment_1017 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1015,@asemeControlInBodyOfSrm,asemeComment_1017 skipwhite skipempty
syntax match asemeComment_1017 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1015,@asemeControlInBodyOfSrm,asemeComment_1017 skipwhite skipempty
syntax match asemeOperator_1015 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax match asemeOperator_1014 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax match asemeOperator_1012 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_1010,@asemeControlInBodyOfSrm,asemeComment_1013 skipwhite skipempty
syntax region asemeComment_1013 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1010,@asemeControlInBodyOfSrm,asemeComment_1013 skipwhite skipempty
syntax match asemeComment_1013 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1010,@asemeControlInBodyOfSrm,asemeComment_1013 skipwhite skipempty
syntax match asemeOperator_1010 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax region asemeComment_1011 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax match asemeComment_1011 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_1011 skipwhite skipempty
syntax match asemeDeclaration_1008 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_1007,asemeComment_1009 skipwhite skipempty
syntax region asemeComment_1009 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1007,asemeComment_1009 skipwhite skipempty
syntax match asemeComment_1009 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1007,asemeComment_1009 skipwhite skipempty
syntax match asemeBlock_1007 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_1004,asemeBlock_1005
syntax match asemeBlock_1005 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax region asemeComment_1006 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax match asemeComment_1006 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_1006 skipwhite skipempty
syntax region asemePunctuation_1004 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_1002,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_1002 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_1001,asemeComment_1003 skipwhite skipempty
syntax region asemeComment_1003 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1001,asemeComment_1003 skipwhite skipempty
syntax match asemeComment_1003 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1001,asemeComment_1003 skipwhite skipempty
syntax match asemeText_1001 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_999 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1000 skipwhite skipempty
syntax region asemeComment_1000 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1000 skipwhite skipempty
syntax match asemeComment_1000 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_1000 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_998
syntax region asemePunctuation_998 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_997,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_997 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_953,asemeClause_956,asemeClause_959,asemeClause_962,asemeClause_965,asemeClause_968,asemeChoice_971,asemeClause_974,asemeClause_977,asemeClause_980,asemeClause_982,asemeChoice_983,asemeChoice_984,asemePunctuation_991,asemeOperator_994,asemeReference_996
syntax match asemeReference_996 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeOperator_994 /\v\=%(\=)@!/ contained nextgroup=asemeText_993,asemeComment_995 skipwhite skipempty
syntax region asemeComment_995 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_993,asemeComment_995 skipwhite skipempty
syntax match asemeComment_995 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_993,asemeComment_995 skipwhite skipempty
syntax match asemeText_993 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemePunctuation_991 /\v\,/ contained nextgroup=asemeChoice_986,asemeReference_988,asemeReference_989,asemeReference_990,asemeComment_992 skipwhite skipempty
syntax region asemeComment_992 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_986,asemeReference_988,asemeReference_989,asemeReference_990,asemeComment_992 skipwhite skipempty
syntax match asemeComment_992 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_986,asemeReference_988,asemeReference_989,asemeReference_990,asemeComment_992 skipwhite skipempty
syntax match asemeReference_990 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeReference_989 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeReference_988 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeChoice_986 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_985,asemeComment_987 skipwhite skipempty
syntax region asemeComment_987 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_985,asemeComment_987 skipwhite skipempty
syntax match asemeComment_987 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_985,asemeComment_987 skipwhite skipempty
syntax match asemeReference_985 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeChoice_984 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeChoice_983 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_982 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_980 /\vends%(<|>)/ contained nextgroup=asemeReference_979,asemeComment_981 skipwhite skipempty
syntax region asemeComment_981 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_979,asemeComment_981 skipwhite skipempty
syntax match asemeComment_981 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_979,asemeComment_981 skipwhite skipempty
syntax match asemeReference_979 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_977 /\vwrites%(<|>)/ contained nextgroup=asemeReference_976,asemeComment_978 skipwhite skipempty
syntax region asemeComment_978 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_976,asemeComment_978 skipwhite skipempty
syntax match asemeComment_978 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_976,asemeComment_978 skipwhite skipempty
syntax match asemeReference_976 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_974 /\vfor%(<|>)/ contained nextgroup=asemeNumber_973,asemeComment_975 skipwhite skipempty
syntax region asemeComment_975 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_973,asemeComment_975 skipwhite skipempty
syntax match asemeComment_975 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_973,asemeComment_975 skipwhite skipempty
syntax match asemeNumber_973 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeChoice_971 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_970,asemeComment_972 skipwhite skipempty
syntax region asemeComment_972 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_970,asemeComment_972 skipwhite skipempty
syntax match asemeComment_972 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_970,asemeComment_972 skipwhite skipempty
syntax match asemeReference_970 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_968 /\vuses%(<|>)/ contained nextgroup=asemeReference_967,asemeComment_969 skipwhite skipempty
syntax region asemeComment_969 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_967,asemeComment_969 skipwhite skipempty
syntax match asemeComment_969 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_967,asemeComment_969 skipwhite skipempty
syntax match asemeReference_967 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_965 /\vas%(<|>)/ contained nextgroup=asemeChoice_964,asemeComment_966 skipwhite skipempty
syntax region asemeComment_966 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_964,asemeComment_966 skipwhite skipempty
syntax match asemeComment_966 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_964,asemeComment_966 skipwhite skipempty
syntax match asemeChoice_964 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_962 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_961,asemeComment_963 skipwhite skipempty
syntax region asemeComment_963 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_961,asemeComment_963 skipwhite skipempty
syntax match asemeComment_963 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_961,asemeComment_963 skipwhite skipempty
syntax match asemeNumber_961 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_959 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_958,asemeComment_960 skipwhite skipempty
syntax region asemeComment_960 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_958,asemeComment_960 skipwhite skipempty
syntax match asemeComment_960 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_958,asemeComment_960 skipwhite skipempty
syntax match asemeNumber_958 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_956 /\vevery%(<|>)/ contained nextgroup=asemeNumber_955,asemeComment_957 skipwhite skipempty
syntax region asemeComment_957 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_955,asemeComment_957 skipwhite skipempty
syntax match asemeComment_957 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_955,asemeComment_957 skipwhite skipempty
syntax match asemeNumber_955 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeClause_953 /\vreads%(<|>)/ contained nextgroup=asemeChoice_950,asemeReference_952,asemeComment_954 skipwhite skipempty
syntax region asemeComment_954 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_950,asemeReference_952,asemeComment_954 skipwhite skipempty
syntax match asemeComment_954 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_950,asemeReference_952,asemeComment_954 skipwhite skipempty
syntax match asemeReference_952 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeChoice_950 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_948,asemeComment_951 skipwhite skipempty
syntax region asemeComment_951 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_948,asemeComment_951 skipwhite skipempty
syntax match asemeComment_951 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_948,asemeComment_951 skipwhite skipempty
syntax match asemeReference_948 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax region asemeComment_949 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeComment_949 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_949 skipwhite skipempty
syntax match asemeDeclaration_946 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_947 skipwhite skipempty
syntax region asemeComment_947 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_947 skipwhite skipempty
syntax match asemeComment_947 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_947 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_945
syntax region asemePunctuation_945 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_944,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_944 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_884,asemeClause_887,asemeClause_890,asemeClause_893,asemeClause_896,asemeClause_899,asemeChoice_902,asemeClause_905,asemeClause_908,asemeClause_911,asemeClause_913,asemeChoice_914,asemeChoice_915,asemePunctuation_922,asemePunctuation_936,asemePunctuation_940,asemePunctuation_942,asemeReference_943
syntax match asemeReference_943 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemePunctuation_942 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemePunctuation_940 /\v\:/ contained nextgroup=asemeBuiltIn_938,asemeType_939,asemeComment_941 skipwhite skipempty
syntax region asemeComment_941 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_938,asemeType_939,asemeComment_941 skipwhite skipempty
syntax match asemeComment_941 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_938,asemeType_939,asemeComment_941 skipwhite skipempty
syntax match asemeType_939 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeBuiltIn_938 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemePunctuation_936 /\v\,/ contained nextgroup=asemeName_928,asemeChoice_931,asemeReference_933,asemeReference_934,asemeReference_935,asemeComment_937 skipwhite skipempty
syntax region asemeComment_937 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_928,asemeChoice_931,asemeReference_933,asemeReference_934,asemeReference_935,asemeComment_937 skipwhite skipempty
syntax match asemeComment_937 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_928,asemeChoice_931,asemeReference_933,asemeReference_934,asemeReference_935,asemeComment_937 skipwhite skipempty
syntax match asemeReference_935 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeReference_934 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeReference_933 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeChoice_931 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_930,asemeComment_932 skipwhite skipempty
syntax region asemeComment_932 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_930,asemeComment_932 skipwhite skipempty
syntax match asemeComment_932 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_930,asemeComment_932 skipwhite skipempty
syntax match asemeReference_930 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeName_928 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_926,asemeComment_929 skipwhite skipempty
syntax region asemeComment_929 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_926,asemeComment_929 skipwhite skipempty
syntax match asemeComment_929 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_926,asemeComment_929 skipwhite skipempty
syntax match asemePunctuation_926 /\v\:/ contained nextgroup=asemeBuiltIn_924,asemeType_925,asemeComment_927 skipwhite skipempty
syntax region asemeComment_927 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_924,asemeType_925,asemeComment_927 skipwhite skipempty
syntax match asemeComment_927 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_924,asemeType_925,asemeComment_927 skipwhite skipempty
syntax match asemeType_925 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeBuiltIn_924 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemePunctuation_922 /\v\(/ contained nextgroup=asemeName_920,asemeComment_923 skipwhite skipempty
syntax region asemeComment_923 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_920,asemeComment_923 skipwhite skipempty
syntax match asemeComment_923 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_920,asemeComment_923 skipwhite skipempty
syntax match asemeName_920 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_918,asemeComment_921 skipwhite skipempty
syntax region asemeComment_921 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_918,asemeComment_921 skipwhite skipempty
syntax match asemeComment_921 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_918,asemeComment_921 skipwhite skipempty
syntax match asemePunctuation_918 /\v\:/ contained nextgroup=asemeBuiltIn_916,asemeType_917,asemeComment_919 skipwhite skipempty
syntax region asemeComment_919 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_916,asemeType_917,asemeComment_919 skipwhite skipempty
syntax match asemeComment_919 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_916,asemeType_917,asemeComment_919 skipwhite skipempty
syntax match asemeType_917 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeBuiltIn_916 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeChoice_915 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeChoice_914 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_913 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_911 /\vends%(<|>)/ contained nextgroup=asemeReference_910,asemeComment_912 skipwhite skipempty
syntax region asemeComment_912 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_910,asemeComment_912 skipwhite skipempty
syntax match asemeComment_912 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_910,asemeComment_912 skipwhite skipempty
syntax match asemeReference_910 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_908 /\vwrites%(<|>)/ contained nextgroup=asemeReference_907,asemeComment_909 skipwhite skipempty
syntax region asemeComment_909 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_907,asemeComment_909 skipwhite skipempty
syntax match asemeComment_909 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_907,asemeComment_909 skipwhite skipempty
syntax match asemeReference_907 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_905 /\vfor%(<|>)/ contained nextgroup=asemeNumber_904,asemeComment_906 skipwhite skipempty
syntax region asemeComment_906 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_904,asemeComment_906 skipwhite skipempty
syntax match asemeComment_906 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_904,asemeComment_906 skipwhite skipempty
syntax match asemeNumber_904 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeChoice_902 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_901,asemeComment_903 skipwhite skipempty
syntax region asemeComment_903 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_901,asemeComment_903 skipwhite skipempty
syntax match asemeComment_903 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_901,asemeComment_903 skipwhite skipempty
syntax match asemeReference_901 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_899 /\vuses%(<|>)/ contained nextgroup=asemeReference_898,asemeComment_900 skipwhite skipempty
syntax region asemeComment_900 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_898,asemeComment_900 skipwhite skipempty
syntax match asemeComment_900 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_898,asemeComment_900 skipwhite skipempty
syntax match asemeReference_898 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_896 /\vas%(<|>)/ contained nextgroup=asemeChoice_895,asemeComment_897 skipwhite skipempty
syntax region asemeComment_897 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_895,asemeComment_897 skipwhite skipempty
syntax match asemeComment_897 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_895,asemeComment_897 skipwhite skipempty
syntax match asemeChoice_895 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_893 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_892,asemeComment_894 skipwhite skipempty
syntax region asemeComment_894 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_892,asemeComment_894 skipwhite skipempty
syntax match asemeComment_894 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_892,asemeComment_894 skipwhite skipempty
syntax match asemeNumber_892 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_890 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_889,asemeComment_891 skipwhite skipempty
syntax region asemeComment_891 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_889,asemeComment_891 skipwhite skipempty
syntax match asemeComment_891 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_889,asemeComment_891 skipwhite skipempty
syntax match asemeNumber_889 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_887 /\vevery%(<|>)/ contained nextgroup=asemeNumber_886,asemeComment_888 skipwhite skipempty
syntax region asemeComment_888 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_886,asemeComment_888 skipwhite skipempty
syntax match asemeComment_888 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_886,asemeComment_888 skipwhite skipempty
syntax match asemeNumber_886 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeClause_884 /\vreads%(<|>)/ contained nextgroup=asemeChoice_881,asemeReference_883,asemeComment_885 skipwhite skipempty
syntax region asemeComment_885 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_881,asemeReference_883,asemeComment_885 skipwhite skipempty
syntax match asemeComment_885 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_881,asemeReference_883,asemeComment_885 skipwhite skipempty
syntax match asemeReference_883 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeChoice_881 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_879,asemeComment_882 skipwhite skipempty
syntax region asemeComment_882 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_879,asemeComment_882 skipwhite skipempty
syntax match asemeComment_882 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_879,asemeComment_882 skipwhite skipempty
syntax match asemeReference_879 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax region asemeComment_880 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeComment_880 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_880 skipwhite skipempty
syntax match asemeDeclaration_877 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_878 skipwhite skipempty
syntax region asemeComment_878 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_878 skipwhite skipempty
syntax match asemeComment_878 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_878 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_876
syntax region asemePunctuation_876 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_875,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_875 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_857,asemePunctuation_861,asemePunctuation_864,asemePunctuation_866,asemeOperator_874
syntax match asemeOperator_874 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemePunctuation_866 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax match asemePunctuation_864 /\v\,/ contained nextgroup=asemeName_863,asemeComment_865 skipwhite skipempty
syntax region asemeComment_865 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_863,asemeComment_865 skipwhite skipempty
syntax match asemeComment_865 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_863,asemeComment_865 skipwhite skipempty
syntax match asemeName_863 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax match asemePunctuation_861 /\v\:/ contained nextgroup=asemeBuiltIn_859,asemeType_860,asemeComment_862 skipwhite skipempty
syntax region asemeComment_862 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_859,asemeType_860,asemeComment_862 skipwhite skipempty
syntax match asemeComment_862 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_859,asemeType_860,asemeComment_862 skipwhite skipempty
syntax match asemeType_860 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax match asemeBuiltIn_859 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax match asemePunctuation_857 /\v\(/ contained nextgroup=asemeName_855,asemeComment_858 skipwhite skipempty
syntax region asemeComment_858 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_855,asemeComment_858 skipwhite skipempty
syntax match asemeComment_858 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_855,asemeComment_858 skipwhite skipempty
syntax match asemeName_855 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax region asemeComment_856 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax match asemeComment_856 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_856 skipwhite skipempty
syntax match asemeDeclaration_853 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_851,asemeComment_854 skipwhite skipempty
syntax region asemeComment_854 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_851,asemeComment_854 skipwhite skipempty
syntax match asemeComment_854 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_851,asemeComment_854 skipwhite skipempty
syntax match asemeName_851 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_850,asemeComment_852 skipwhite skipempty
syntax region asemeComment_852 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_850,asemeComment_852 skipwhite skipempty
syntax match asemeComment_852 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_850,asemeComment_852 skipwhite skipempty
syntax match asemeOperator_850 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_848 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_846,asemeComment_849 skipwhite skipempty
syntax region asemeComment_849 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_846,asemeComment_849 skipwhite skipempty
syntax match asemeComment_849 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_846,asemeComment_849 skipwhite skipempty
syntax match asemeName_846 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_844,asemeComment_847 skipwhite skipempty
syntax region asemeComment_847 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_844,asemeComment_847 skipwhite skipempty
syntax match asemeComment_847 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_844,asemeComment_847 skipwhite skipempty
syntax match asemePunctuation_844 /\v\:/ contained nextgroup=asemeBuiltIn_842,asemeType_843,asemeComment_845 skipwhite skipempty
syntax region asemeComment_845 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_842,asemeType_843,asemeComment_845 skipwhite skipempty
syntax match asemeComment_845 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_842,asemeType_843,asemeComment_845 skipwhite skipempty
syntax match asemeType_843 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeBuiltIn_842 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_800,asemeOperator_833,asemeName_838,asemeBuiltIn_840,asemeType_841
syntax match asemeType_841 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeBuiltIn_840 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeName_838 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_836,asemeComment_839 skipwhite skipempty
syntax region asemeComment_839 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_836,asemeComment_839 skipwhite skipempty
syntax match asemeComment_839 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_836,asemeComment_839 skipwhite skipempty
syntax match asemePunctuation_836 /\v\:/ contained nextgroup=asemeBuiltIn_834,asemeType_835,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_834,asemeType_835,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_834,asemeType_835,asemeComment_837 skipwhite skipempty
syntax match asemeType_835 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeBuiltIn_834 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeOperator_833 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemePunctuation_800 /\v\:/ contained nextgroup=asemeBuiltIn_797,asemeType_799,asemeComment_801 skipwhite skipempty
syntax region asemeComment_801 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_797,asemeType_799,asemeComment_801 skipwhite skipempty
syntax match asemeComment_801 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_797,asemeType_799,asemeComment_801 skipwhite skipempty
syntax match asemeType_799 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeBuiltIn_797 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax region asemeComment_798 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeComment_798 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_798 skipwhite skipempty
syntax match asemeDeclaration_795 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_793,asemeComment_796 skipwhite skipempty
syntax region asemeComment_796 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_793,asemeComment_796 skipwhite skipempty
syntax match asemeComment_796 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_793,asemeComment_796 skipwhite skipempty
syntax match asemeName_793 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_792,@asemeCapabilityInBodyOfSrm,asemeComment_794 skipwhite skipempty
syntax region asemeComment_794 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_792,@asemeCapabilityInBodyOfSrm,asemeComment_794 skipwhite skipempty
syntax match asemeComment_794 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_792,@asemeCapabilityInBodyOfSrm,asemeComment_794 skipwhite skipempty
syntax match asemeText_792 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_783,asemePunctuation_786,asemeText_788,asemeName_790
syntax match asemeName_790 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_789,@asemeCapabilityInBodyOfSrm,asemeComment_791 skipwhite skipempty
syntax region asemeComment_791 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_789,@asemeCapabilityInBodyOfSrm,asemeComment_791 skipwhite skipempty
syntax match asemeComment_791 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_789,@asemeCapabilityInBodyOfSrm,asemeComment_791 skipwhite skipempty
syntax match asemeText_789 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax match asemeText_788 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax match asemePunctuation_786 /\v\,/ contained nextgroup=asemeReference_785,asemeComment_787 skipwhite skipempty
syntax region asemeComment_787 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_785,asemeComment_787 skipwhite skipempty
syntax match asemeComment_787 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_785,asemeComment_787 skipwhite skipempty
syntax match asemeReference_785 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax match asemeOperator_783 /\v\=%(\=)@!/ contained nextgroup=asemeReference_781,asemeComment_784 skipwhite skipempty
syntax region asemeComment_784 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_781,asemeComment_784 skipwhite skipempty
syntax match asemeComment_784 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_781,asemeComment_784 skipwhite skipempty
syntax match asemeReference_781 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax region asemeComment_782 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax match asemeComment_782 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_782 skipwhite skipempty
syntax match asemeDeclaration_779 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_777,asemeComment_780 skipwhite skipempty
syntax region asemeComment_780 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_777,asemeComment_780 skipwhite skipempty
syntax match asemeComment_780 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_777,asemeComment_780 skipwhite skipempty
syntax match asemeReference_777 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_775,asemeComment_778 skipwhite skipempty
syntax region asemeComment_778 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_775,asemeComment_778 skipwhite skipempty
syntax match asemeComment_778 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_775,asemeComment_778 skipwhite skipempty
syntax match asemePunctuation_775 /\v\./ contained nextgroup=asemeReference_774,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_774,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_774,asemeComment_776 skipwhite skipempty
syntax match asemeReference_774 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_721,asemeClause_725,asemeClause_754,asemeClause_756,asemePunctuation_763,asemePunctuation_766,asemeOperator_768,asemeReference_772
syntax match asemeReference_772 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_770,@asemePlaysInBodyOfSrm,asemeComment_773 skipwhite skipempty
syntax region asemeComment_773 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_770,@asemePlaysInBodyOfSrm,asemeComment_773 skipwhite skipempty
syntax match asemeComment_773 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_770,@asemePlaysInBodyOfSrm,asemeComment_773 skipwhite skipempty
syntax match asemePunctuation_770 /\v\./ contained nextgroup=asemeReference_769,asemeComment_771 skipwhite skipempty
syntax region asemeComment_771 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_769,asemeComment_771 skipwhite skipempty
syntax match asemeComment_771 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_769,asemeComment_771 skipwhite skipempty
syntax match asemeReference_769 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax match asemeOperator_768 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemePunctuation_766 /\v\./ contained nextgroup=asemeReference_765,asemeComment_767 skipwhite skipempty
syntax region asemeComment_767 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_765,asemeComment_767 skipwhite skipempty
syntax match asemeComment_767 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_765,asemeComment_767 skipwhite skipempty
syntax match asemeReference_765 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax match asemePunctuation_763 /\v\,/ contained nextgroup=asemeReference_761,asemeComment_764 skipwhite skipempty
syntax region asemeComment_764 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_761,asemeComment_764 skipwhite skipempty
syntax match asemeComment_764 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_761,asemeComment_764 skipwhite skipempty
syntax match asemeReference_761 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\.|\=%(\=)@!))@=/ contained nextgroup=asemePunctuation_758,asemeOperator_760,asemeComment_762 skipwhite skipempty
syntax region asemeComment_762 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_758,asemeOperator_760,asemeComment_762 skipwhite skipempty
syntax match asemeComment_762 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_758,asemeOperator_760,asemeComment_762 skipwhite skipempty
syntax match asemeOperator_760 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemePunctuation_758 /\v\./ contained nextgroup=asemeReference_757,asemeComment_759 skipwhite skipempty
syntax region asemeComment_759 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_757,asemeComment_759 skipwhite skipempty
syntax match asemeComment_759 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_757,asemeComment_759 skipwhite skipempty
syntax match asemeReference_757 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax match asemeClause_756 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_754 /\vwhen%(<|>)/ contained nextgroup=asemeClause_753,asemeComment_755 skipwhite skipempty
syntax region asemeComment_755 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_753,asemeComment_755 skipwhite skipempty
syntax match asemeComment_755 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_753,asemeComment_755 skipwhite skipempty
syntax match asemeClause_753 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_725 /\vas%(<|>)/ contained nextgroup=asemeReference_723,asemeComment_726 skipwhite skipempty
syntax region asemeComment_726 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_723,asemeComment_726 skipwhite skipempty
syntax match asemeComment_726 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_723,asemeComment_726 skipwhite skipempty
syntax match asemeReference_723 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax region asemeComment_724 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax match asemeComment_724 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_724 skipwhite skipempty
syntax match asemeClause_721 /\vwith%(<|>)/ contained nextgroup=asemeReference_719,asemeComment_722 skipwhite skipempty
syntax region asemeComment_722 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_719,asemeComment_722 skipwhite skipempty
syntax match asemeComment_722 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_719,asemeComment_722 skipwhite skipempty
syntax match asemeReference_719 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_718,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_718,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_718,asemeComment_720 skipwhite skipempty
syntax match asemeOperator_718 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeDeclaration_685 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_684,asemeComment_686 skipwhite skipempty
syntax region asemeComment_686 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_684,asemeComment_686 skipwhite skipempty
syntax match asemeComment_686 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_684,asemeComment_686 skipwhite skipempty
syntax match asemeReference_684 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_681,asemeReference_683
syntax match asemeReference_683 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax match asemePunctuation_681 /\v\,/ contained nextgroup=asemeReference_679,asemeComment_682 skipwhite skipempty
syntax region asemeComment_682 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_679,asemeComment_682 skipwhite skipempty
syntax match asemeComment_682 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_679,asemeComment_682 skipwhite skipempty
syntax match asemeReference_679 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax region asemeComment_680 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax match asemeComment_680 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_680 skipwhite skipempty
syntax match asemeClause_677 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_675,asemeComment_678 skipwhite skipempty
syntax region asemeComment_678 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_675,asemeComment_678 skipwhite skipempty
syntax match asemeComment_678 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_675,asemeComment_678 skipwhite skipempty
syntax match asemeBlock_675 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_676 skipwhite skipempty
syntax region asemeComment_676 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_676 skipwhite skipempty
syntax match asemeComment_676 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_676 skipwhite skipempty
syntax match asemeDeclaration_673 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_672,asemeComment_674 skipwhite skipempty
syntax region asemeComment_674 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_672,asemeComment_674 skipwhite skipempty
syntax match asemeComment_674 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_672,asemeComment_674 skipwhite skipempty
syntax match asemeBlock_672 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_671 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_669,asemeBlock_670
syntax match asemeBlock_670 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_671 skipwhite skipempty
syntax region asemeComment_671 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_671 skipwhite skipempty
syntax match asemeComment_671 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_671 skipwhite skipempty
syntax region asemePunctuation_669 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_523,asemeDeclaration_526,asemeDeclaration_559,asemeDeclaration_563,asemeDeclaration_667,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_667 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_665,asemeComment_668 skipwhite skipempty
syntax region asemeComment_668 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_665,asemeComment_668 skipwhite skipempty
syntax match asemeComment_668 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_665,asemeComment_668 skipwhite skipempty
syntax match asemeBlock_665 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_662,asemeOperator_664,@asemeControlInBodyOfAip,asemeComment_666 skipwhite skipempty
syntax region asemeComment_666 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_662,asemeOperator_664,@asemeControlInBodyOfAip,asemeComment_666 skipwhite skipempty
syntax match asemeComment_666 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_662,asemeOperator_664,@asemeControlInBodyOfAip,asemeComment_666 skipwhite skipempty
syntax match asemeOperator_664 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax match asemeOperator_662 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_661,@asemeControlInBodyOfAip,asemeComment_663 skipwhite skipempty
syntax region asemeComment_663 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_661,@asemeControlInBodyOfAip,asemeComment_663 skipwhite skipempty
syntax match asemeComment_663 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_661,@asemeControlInBodyOfAip,asemeComment_663 skipwhite skipempty
syntax match asemeOperator_661 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemeOperator_567,asemePunctuation_653,asemeOperator_654,asemeBlock_659
syntax match asemeBlock_659 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_656,asemeOperator_658,@asemeControlInBodyOfAip,asemeComment_660 skipwhite skipempty
syntax region asemeComment_660 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_656,asemeOperator_658,@asemeControlInBodyOfAip,asemeComment_660 skipwhite skipempty
syntax match asemeComment_660 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_656,asemeOperator_658,@asemeControlInBodyOfAip,asemeComment_660 skipwhite skipempty
syntax match asemeOperator_658 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax match asemeOperator_656 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_655,@asemeControlInBodyOfAip,asemeComment_657 skipwhite skipempty
syntax region asemeComment_657 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_655,@asemeControlInBodyOfAip,asemeComment_657 skipwhite skipempty
syntax match asemeComment_657 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_655,@asemeControlInBodyOfAip,asemeComment_657 skipwhite skipempty
syntax match asemeOperator_655 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax match asemeOperator_654 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax region asemePunctuation_653 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_614,asemeNumber_651,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeNumber_651 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_649,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_649,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_649,asemeComment_652 skipwhite skipempty
syntax match asemeOperator_649 /\v\-\>/ contained nextgroup=asemeNumber_647,asemeComment_650 skipwhite skipempty
syntax region asemeComment_650 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_647,asemeComment_650 skipwhite skipempty
syntax match asemeComment_650 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_647,asemeComment_650 skipwhite skipempty
syntax match asemeNumber_647 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_646,asemeComment_648 skipwhite skipempty
syntax region asemeComment_648 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_646,asemeComment_648 skipwhite skipempty
syntax match asemeComment_648 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_646,asemeComment_648 skipwhite skipempty
syntax match asemePunctuation_646 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeDeclaration_614 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_571,asemeOperator_574,asemePunctuation_607,asemeText_608,asemeNumber_609,asemeReference_610,asemeNumber_611,asemeOperator_612,asemePunctuation_613
syntax match asemePunctuation_613 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeOperator_612 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeNumber_611 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeReference_610 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeNumber_609 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeText_608 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemePunctuation_607 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeOperator_574 /\v\#/ contained nextgroup=asemeNumber_573,asemeComment_575 skipwhite skipempty
syntax region asemeComment_575 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_573,asemeComment_575 skipwhite skipempty
syntax match asemeComment_575 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_573,asemeComment_575 skipwhite skipempty
syntax match asemeNumber_573 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeClause_571 /\vevery%(<|>)/ contained nextgroup=asemeNumber_569,asemeComment_572 skipwhite skipempty
syntax region asemeComment_572 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_569,asemeComment_572 skipwhite skipempty
syntax match asemeComment_572 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_569,asemeComment_572 skipwhite skipempty
syntax match asemeNumber_569 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax region asemeComment_570 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeComment_570 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_570 skipwhite skipempty
syntax match asemeOperator_567 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_565,@asemeControlInBodyOfAip,asemeComment_568 skipwhite skipempty
syntax region asemeComment_568 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_565,@asemeControlInBodyOfAip,asemeComment_568 skipwhite skipempty
syntax match asemeComment_568 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_565,@asemeControlInBodyOfAip,asemeComment_568 skipwhite skipempty
syntax match asemeOperator_565 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax region asemeComment_566 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax match asemeComment_566 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_566 skipwhite skipempty
syntax match asemeDeclaration_563 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_561,asemeComment_564 skipwhite skipempty
syntax region asemeComment_564 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_561,asemeComment_564 skipwhite skipempty
syntax match asemeComment_564 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_561,asemeComment_564 skipwhite skipempty
syntax match asemeName_561 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_560,asemeComment_562 skipwhite skipempty
syntax region asemeComment_562 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_560,asemeComment_562 skipwhite skipempty
syntax match asemeComment_562 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_560,asemeComment_562 skipwhite skipempty
syntax match asemeOperator_560 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_559 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_533,asemeClause_537,asemeClause_540,asemeClause_543,asemeClause_546,asemeClause_548,asemeClause_549,asemeClause_550,asemePunctuation_552,asemeOperator_555,asemePunctuation_557,asemeName_558
syntax match asemeName_558 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemePunctuation_557 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeOperator_555 /\v\@/ contained nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax match asemeReference_554 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemePunctuation_552 /\v\(/ contained nextgroup=asemeName_551,asemeComment_553 skipwhite skipempty
syntax region asemeComment_553 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_551,asemeComment_553 skipwhite skipempty
syntax match asemeComment_553 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_551,asemeComment_553 skipwhite skipempty
syntax match asemeName_551 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_550 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_549 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_548 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_546 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax match asemeNumber_545 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_543 /\vleads%(<|>)/ contained nextgroup=asemeClause_542,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_542,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_542,asemeComment_544 skipwhite skipempty
syntax match asemeClause_542 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_540 /\vor%(<|>)/ contained nextgroup=asemeName_539,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_539,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_539,asemeComment_541 skipwhite skipempty
syntax match asemeName_539 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_537 /\vmost%(<|>)/ contained nextgroup=asemeChoice_535,asemeNumber_536,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_535,asemeNumber_536,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_535,asemeNumber_536,asemeComment_538 skipwhite skipempty
syntax match asemeNumber_536 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeChoice_535 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeClause_533 /\vat%(<|>)/ contained nextgroup=asemeClause_531,asemeComment_534 skipwhite skipempty
syntax region asemeComment_534 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_531,asemeComment_534 skipwhite skipempty
syntax match asemeComment_534 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_531,asemeComment_534 skipwhite skipempty
syntax match asemeClause_531 /\vmost%(<|>)/ contained nextgroup=asemeChoice_528,asemeNumber_530,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_528,asemeNumber_530,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_528,asemeNumber_530,asemeComment_532 skipwhite skipempty
syntax match asemeNumber_530 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeChoice_528 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax region asemeComment_529 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeComment_529 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_529 skipwhite skipempty
syntax match asemeDeclaration_526 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_525,asemeComment_527 skipwhite skipempty
syntax region asemeComment_527 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_525,asemeComment_527 skipwhite skipempty
syntax match asemeComment_527 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_525,asemeComment_527 skipwhite skipempty
syntax match asemeText_525 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_523 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_522,asemeComment_524 skipwhite skipempty
syntax region asemeComment_524 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_522,asemeComment_524 skipwhite skipempty
syntax match asemeComment_524 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_522,asemeComment_524 skipwhite skipempty
syntax match asemeBlock_522 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_242,asemePunctuation_245,asemePunctuation_247,asemePunctuation_520,asemeBlock_521
syntax match asemeBlock_521 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax region asemePunctuation_520 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_249,asemeDeclaration_343,asemeDeclaration_396,asemeDeclaration_404,asemeDeclaration_457,asemeDeclaration_462,asemeDeclaration_483,asemeDeclaration_497,asemeName_519,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_519 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_501,asemePunctuation_505,asemePunctuation_508,asemePunctuation_510,asemeOperator_518
syntax match asemeOperator_518 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemePunctuation_510 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax match asemePunctuation_508 /\v\,/ contained nextgroup=asemeName_507,asemeComment_509 skipwhite skipempty
syntax region asemeComment_509 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_507,asemeComment_509 skipwhite skipempty
syntax match asemeComment_509 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_507,asemeComment_509 skipwhite skipempty
syntax match asemeName_507 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax match asemePunctuation_505 /\v\:/ contained nextgroup=asemeBuiltIn_503,asemeType_504,asemeComment_506 skipwhite skipempty
syntax region asemeComment_506 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_503,asemeType_504,asemeComment_506 skipwhite skipempty
syntax match asemeComment_506 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_503,asemeType_504,asemeComment_506 skipwhite skipempty
syntax match asemeType_504 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax match asemeBuiltIn_503 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax match asemePunctuation_501 /\v\(/ contained nextgroup=asemeName_499,asemeComment_502 skipwhite skipempty
syntax region asemeComment_502 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_499,asemeComment_502 skipwhite skipempty
syntax match asemeComment_502 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_499,asemeComment_502 skipwhite skipempty
syntax match asemeName_499 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax region asemeComment_500 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax match asemeComment_500 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_500 skipwhite skipempty
syntax match asemeDeclaration_497 /\v%(receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_495,asemeComment_498 skipwhite skipempty
syntax region asemeComment_498 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_495,asemeComment_498 skipwhite skipempty
syntax match asemeComment_498 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_495,asemeComment_498 skipwhite skipempty
syntax match asemeReference_495 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax region asemeComment_496 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeComment_496 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeReference_494 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_486 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_489,asemeReference_492
syntax match asemeReference_492 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_491,@asemeReceivesInBodyOfParticipant,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_491,@asemeReceivesInBodyOfParticipant,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_491,@asemeReceivesInBodyOfParticipant,asemeComment_493 skipwhite skipempty
syntax match asemeReference_491 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_486 skipwhite skipempty
syntax match asemePunctuation_489 /\v\,/ contained nextgroup=asemeReference_487,asemeComment_490 skipwhite skipempty
syntax region asemeComment_490 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_487,asemeComment_490 skipwhite skipempty
syntax match asemeComment_490 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_487,asemeComment_490 skipwhite skipempty
syntax match asemeReference_487 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_485,asemeComment_488 skipwhite skipempty
syntax region asemeComment_488 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_485,asemeComment_488 skipwhite skipempty
syntax match asemeComment_488 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_485,asemeComment_488 skipwhite skipempty
syntax match asemeReference_485 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_486 skipwhite skipempty
syntax match asemeDeclaration_483 /\v%(sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_481,asemeComment_484 skipwhite skipempty
syntax region asemeComment_484 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_481,asemeComment_484 skipwhite skipempty
syntax match asemeComment_484 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_481,asemeComment_484 skipwhite skipempty
syntax match asemeReference_481 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_480,asemeComment_482 skipwhite skipempty
syntax region asemeComment_482 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_480,asemeComment_482 skipwhite skipempty
syntax match asemeComment_482 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_480,asemeComment_482 skipwhite skipempty
syntax match asemeReference_480 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_466,asemeClause_469,asemeClause_471,asemePunctuation_475,asemeReference_478
syntax match asemeReference_478 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_477,@asemeSendsInBodyOfParticipant,asemeComment_479 skipwhite skipempty
syntax region asemeComment_479 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_477,@asemeSendsInBodyOfParticipant,asemeComment_479 skipwhite skipempty
syntax match asemeComment_479 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_477,@asemeSendsInBodyOfParticipant,asemeComment_479 skipwhite skipempty
syntax match asemeReference_477 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax match asemePunctuation_475 /\v\,/ contained nextgroup=asemeReference_473,asemeComment_476 skipwhite skipempty
syntax region asemeComment_476 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_473,asemeComment_476 skipwhite skipempty
syntax match asemeComment_476 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_473,asemeComment_476 skipwhite skipempty
syntax match asemeReference_473 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_472,asemeComment_474 skipwhite skipempty
syntax region asemeComment_474 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_472,asemeComment_474 skipwhite skipempty
syntax match asemeComment_474 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_472,asemeComment_474 skipwhite skipempty
syntax match asemeReference_472 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax match asemeClause_471 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax match asemeClause_469 /\vor%(<|>)/ contained nextgroup=asemeReference_468,asemeComment_470 skipwhite skipempty
syntax region asemeComment_470 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_468,asemeComment_470 skipwhite skipempty
syntax match asemeComment_470 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_468,asemeComment_470 skipwhite skipempty
syntax match asemeReference_468 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax match asemeClause_466 /\vby%(<|>)/ contained nextgroup=asemeReference_464,asemeComment_467 skipwhite skipempty
syntax region asemeComment_467 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_464,asemeComment_467 skipwhite skipempty
syntax match asemeComment_467 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_464,asemeComment_467 skipwhite skipempty
syntax match asemeReference_464 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax region asemeComment_465 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax match asemeComment_465 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_465 skipwhite skipempty
syntax match asemeDeclaration_462 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_460,asemeComment_463 skipwhite skipempty
syntax region asemeComment_463 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_460,asemeComment_463 skipwhite skipempty
syntax match asemeComment_463 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_460,asemeComment_463 skipwhite skipempty
syntax match asemeName_460 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_459,asemeComment_461 skipwhite skipempty
syntax region asemeComment_461 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_459,asemeComment_461 skipwhite skipempty
syntax match asemeComment_461 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_459,asemeComment_461 skipwhite skipempty
syntax match asemeOperator_459 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_457 /\v%(result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=result%(<|>)/ contained nextgroup=asemeName_455,asemeComment_458 skipwhite skipempty
syntax region asemeComment_458 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_455,asemeComment_458 skipwhite skipempty
syntax match asemeComment_458 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_455,asemeComment_458 skipwhite skipempty
syntax match asemeName_455 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_453,asemeComment_456 skipwhite skipempty
syntax region asemeComment_456 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_453,asemeComment_456 skipwhite skipempty
syntax match asemeComment_456 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_453,asemeComment_456 skipwhite skipempty
syntax match asemePunctuation_453 /\v\:/ contained nextgroup=asemeBuiltIn_451,asemeType_452,asemeComment_454 skipwhite skipempty
syntax region asemeComment_454 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_451,asemeType_452,asemeComment_454 skipwhite skipempty
syntax match asemeComment_454 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_451,asemeType_452,asemeComment_454 skipwhite skipempty
syntax match asemeType_452 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeBuiltIn_451 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax cluster asemeResultInBodyOfParticipant contains=asemePunctuation_409,asemeOperator_442,asemeName_447,asemeBuiltIn_449,asemeType_450
syntax match asemeType_450 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeBuiltIn_449 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeName_447 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_445,asemeComment_448 skipwhite skipempty
syntax region asemeComment_448 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_445,asemeComment_448 skipwhite skipempty
syntax match asemeComment_448 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_445,asemeComment_448 skipwhite skipempty
syntax match asemePunctuation_445 /\v\:/ contained nextgroup=asemeBuiltIn_443,asemeType_444,asemeComment_446 skipwhite skipempty
syntax region asemeComment_446 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_443,asemeType_444,asemeComment_446 skipwhite skipempty
syntax match asemeComment_446 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_443,asemeType_444,asemeComment_446 skipwhite skipempty
syntax match asemeType_444 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeBuiltIn_443 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeOperator_442 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemePunctuation_409 /\v\:/ contained nextgroup=asemeBuiltIn_406,asemeType_408,asemeComment_410 skipwhite skipempty
syntax region asemeComment_410 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_406,asemeType_408,asemeComment_410 skipwhite skipempty
syntax match asemeComment_410 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_406,asemeType_408,asemeComment_410 skipwhite skipempty
syntax match asemeType_408 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeBuiltIn_406 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax region asemeComment_407 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeComment_407 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_407 skipwhite skipempty
syntax match asemeDeclaration_404 /\v%(given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=given%(<|>)/ contained nextgroup=asemeName_402,asemeComment_405 skipwhite skipempty
syntax region asemeComment_405 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_402,asemeComment_405 skipwhite skipempty
syntax match asemeComment_405 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_402,asemeComment_405 skipwhite skipempty
syntax match asemeName_402 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_400,asemeComment_403 skipwhite skipempty
syntax region asemeComment_403 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_400,asemeComment_403 skipwhite skipempty
syntax match asemeComment_403 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_400,asemeComment_403 skipwhite skipempty
syntax match asemePunctuation_400 /\v\:/ contained nextgroup=asemeBuiltIn_398,asemeType_399,asemeComment_401 skipwhite skipempty
syntax region asemeComment_401 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_398,asemeType_399,asemeComment_401 skipwhite skipempty
syntax match asemeComment_401 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_398,asemeType_399,asemeComment_401 skipwhite skipempty
syntax match asemeType_399 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained
syntax match asemeBuiltIn_398 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained
syntax match asemeDeclaration_396 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_394,asemeComment_397 skipwhite skipempty
syntax region asemeComment_397 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_394,asemeComment_397 skipwhite skipempty
syntax match asemeComment_397 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_394,asemeComment_397 skipwhite skipempty
syntax match asemeName_394 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_392,asemeComment_395 skipwhite skipempty
syntax region asemeComment_395 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_392,asemeComment_395 skipwhite skipempty
syntax match asemeComment_395 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_392,asemeComment_395 skipwhite skipempty
syntax match asemePunctuation_392 /\v\:/ contained nextgroup=asemeBuiltIn_390,asemeType_391,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_390,asemeType_391,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_390,asemeType_391,asemeComment_393 skipwhite skipempty
syntax match asemeType_391 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeBuiltIn_390 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemePunctuation_348,asemeOperator_381,asemeName_386,asemeBuiltIn_388,asemeType_389
syntax match asemeType_389 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeBuiltIn_388 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeName_386 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_384,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_384,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_384,asemeComment_387 skipwhite skipempty
syntax match asemePunctuation_384 /\v\:/ contained nextgroup=asemeBuiltIn_382,asemeType_383,asemeComment_385 skipwhite skipempty
syntax region asemeComment_385 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_382,asemeType_383,asemeComment_385 skipwhite skipempty
syntax match asemeComment_385 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_382,asemeType_383,asemeComment_385 skipwhite skipempty
syntax match asemeType_383 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeBuiltIn_382 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeOperator_381 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemePunctuation_348 /\v\:/ contained nextgroup=asemeBuiltIn_345,asemeType_347,asemeComment_349 skipwhite skipempty
syntax region asemeComment_349 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_345,asemeType_347,asemeComment_349 skipwhite skipempty
syntax match asemeComment_349 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_345,asemeType_347,asemeComment_349 skipwhite skipempty
syntax match asemeType_347 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeBuiltIn_345 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax region asemeComment_346 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeComment_346 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_346 skipwhite skipempty
syntax match asemeDeclaration_343 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_341,asemeComment_344 skipwhite skipempty
syntax region asemeComment_344 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_341,asemeComment_344 skipwhite skipempty
syntax match asemeComment_344 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_341,asemeComment_344 skipwhite skipempty
syntax match asemeReference_341 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_339,asemeComment_342 skipwhite skipempty
syntax region asemeComment_342 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_339,asemeComment_342 skipwhite skipempty
syntax match asemeComment_342 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_339,asemeComment_342 skipwhite skipempty
syntax match asemePunctuation_339 /\v\./ contained nextgroup=asemeReference_338,asemeComment_340 skipwhite skipempty
syntax region asemeComment_340 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_338,asemeComment_340 skipwhite skipempty
syntax match asemeComment_340 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_338,asemeComment_340 skipwhite skipempty
syntax match asemeReference_338 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax cluster asemePlaysInBodyOfParticipant contains=asemeClause_285,asemeClause_289,asemeClause_318,asemeClause_320,asemePunctuation_327,asemePunctuation_330,asemeOperator_332,asemeReference_336
syntax match asemeReference_336 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_334,@asemePlaysInBodyOfParticipant,asemeComment_337 skipwhite skipempty
syntax region asemeComment_337 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_334,@asemePlaysInBodyOfParticipant,asemeComment_337 skipwhite skipempty
syntax match asemeComment_337 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_334,@asemePlaysInBodyOfParticipant,asemeComment_337 skipwhite skipempty
syntax match asemePunctuation_334 /\v\./ contained nextgroup=asemeReference_333,asemeComment_335 skipwhite skipempty
syntax region asemeComment_335 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_333,asemeComment_335 skipwhite skipempty
syntax match asemeComment_335 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_333,asemeComment_335 skipwhite skipempty
syntax match asemeReference_333 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemeOperator_332 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemePunctuation_330 /\v\./ contained nextgroup=asemeReference_329,asemeComment_331 skipwhite skipempty
syntax region asemeComment_331 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_329,asemeComment_331 skipwhite skipempty
syntax match asemeComment_331 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_329,asemeComment_331 skipwhite skipempty
syntax match asemeReference_329 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemePunctuation_327 /\v\,/ contained nextgroup=asemeReference_325,asemeComment_328 skipwhite skipempty
syntax region asemeComment_328 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_325,asemeComment_328 skipwhite skipempty
syntax match asemeComment_328 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_325,asemeComment_328 skipwhite skipempty
syntax match asemeReference_325 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\.|\=%(\=)@!))@=/ contained nextgroup=asemePunctuation_322,asemeOperator_324,asemeComment_326 skipwhite skipempty
syntax region asemeComment_326 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_322,asemeOperator_324,asemeComment_326 skipwhite skipempty
syntax match asemeComment_326 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_322,asemeOperator_324,asemeComment_326 skipwhite skipempty
syntax match asemeOperator_324 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemePunctuation_322 /\v\./ contained nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax region asemeComment_323 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax match asemeComment_323 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax match asemeReference_321 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemeClause_320 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_318 /\vwhen%(<|>)/ contained nextgroup=asemeClause_317,asemeComment_319 skipwhite skipempty
syntax region asemeComment_319 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_317,asemeComment_319 skipwhite skipempty
syntax match asemeComment_319 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_317,asemeComment_319 skipwhite skipempty
syntax match asemeClause_317 /\vbusy%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_289 /\vas%(<|>)/ contained nextgroup=asemeReference_287,asemeComment_290 skipwhite skipempty
syntax region asemeComment_290 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_287,asemeComment_290 skipwhite skipempty
syntax match asemeComment_290 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_287,asemeComment_290 skipwhite skipempty
syntax match asemeReference_287 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax region asemeComment_288 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemeComment_288 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemeClause_285 /\vwith%(<|>)/ contained nextgroup=asemeReference_283,asemeComment_286 skipwhite skipempty
syntax region asemeComment_286 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_283,asemeComment_286 skipwhite skipempty
syntax match asemeComment_286 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_283,asemeComment_286 skipwhite skipempty
syntax match asemeReference_283 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_282,asemeComment_284 skipwhite skipempty
syntax region asemeComment_284 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_282,asemeComment_284 skipwhite skipempty
syntax match asemeComment_284 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_282,asemeComment_284 skipwhite skipempty
syntax match asemeOperator_282 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeDeclaration_249 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_248,asemeComment_250 skipwhite skipempty
syntax region asemeComment_250 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_248,asemeComment_250 skipwhite skipempty
syntax match asemeComment_250 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_248,asemeComment_250 skipwhite skipempty
syntax match asemeText_248 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_247 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax match asemePunctuation_245 /\v\.\./ contained nextgroup=asemeNumber_244,asemeComment_246 skipwhite skipempty
syntax region asemeComment_246 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_244,asemeComment_246 skipwhite skipempty
syntax match asemeComment_246 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_244,asemeComment_246 skipwhite skipempty
syntax match asemeNumber_244 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax match asemePunctuation_242 /\v\[/ contained nextgroup=asemeNumber_240,asemeComment_243 skipwhite skipempty
syntax region asemeComment_243 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_240,asemeComment_243 skipwhite skipempty
syntax match asemeComment_243 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_240,asemeComment_243 skipwhite skipempty
syntax match asemeNumber_240 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax region asemeComment_241 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax match asemeComment_241 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax match asemeDeclaration_238 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_239 skipwhite skipempty
syntax region asemeComment_239 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_239 skipwhite skipempty
syntax match asemeComment_239 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_239 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_237
syntax region asemePunctuation_237 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_217,asemeDeclaration_235,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_235 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_234,asemeComment_236 skipwhite skipempty
syntax region asemeComment_236 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_234,asemeComment_236 skipwhite skipempty
syntax match asemeComment_236 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_234,asemeComment_236 skipwhite skipempty
syntax match asemeName_234 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_221,asemeClause_224,asemeClause_227,asemePunctuation_230,asemeText_232,asemeName_233
syntax match asemeName_233 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemeText_232 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemePunctuation_230 /\v\,/ contained nextgroup=asemeReference_229,asemeComment_231 skipwhite skipempty
syntax region asemeComment_231 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_229,asemeComment_231 skipwhite skipempty
syntax match asemeComment_231 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_229,asemeComment_231 skipwhite skipempty
syntax match asemeReference_229 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemeClause_227 /\vrealises%(<|>)/ contained nextgroup=asemeReference_226,asemeComment_228 skipwhite skipempty
syntax region asemeComment_228 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_226,asemeComment_228 skipwhite skipempty
syntax match asemeComment_228 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_226,asemeComment_228 skipwhite skipempty
syntax match asemeReference_226 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemeClause_224 /\vincludes%(<|>)/ contained nextgroup=asemeReference_223,asemeComment_225 skipwhite skipempty
syntax region asemeComment_225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_223,asemeComment_225 skipwhite skipempty
syntax match asemeComment_225 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_223,asemeComment_225 skipwhite skipempty
syntax match asemeReference_223 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemeClause_221 /\vby%(<|>)/ contained nextgroup=asemeReference_219,asemeComment_222 skipwhite skipempty
syntax region asemeComment_222 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_219,asemeComment_222 skipwhite skipempty
syntax match asemeComment_222 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_219,asemeComment_222 skipwhite skipempty
syntax match asemeReference_219 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax region asemeComment_220 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemeComment_220 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_220 skipwhite skipempty
syntax match asemeDeclaration_217 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_216,asemeComment_218 skipwhite skipempty
syntax region asemeComment_218 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_216,asemeComment_218 skipwhite skipempty
syntax match asemeComment_218 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_216,asemeComment_218 skipwhite skipempty
syntax match asemeReference_216 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemeChoice_207,asemePunctuation_210,asemePunctuation_213,asemeReference_215
syntax match asemeReference_215 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax match asemePunctuation_213 /\v\:/ contained nextgroup=asemeChoice_212,asemeComment_214 skipwhite skipempty
syntax region asemeComment_214 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_212,asemeComment_214 skipwhite skipempty
syntax match asemeComment_214 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_212,asemeComment_214 skipwhite skipempty
syntax match asemeChoice_212 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax match asemePunctuation_210 /\v\,/ contained nextgroup=asemeReference_209,asemeComment_211 skipwhite skipempty
syntax region asemeComment_211 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_209,asemeComment_211 skipwhite skipempty
syntax match asemeComment_211 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_209,asemeComment_211 skipwhite skipempty
syntax match asemeReference_209 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax match asemeChoice_207 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax region asemeComment_208 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax match asemeComment_208 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_208 skipwhite skipempty
syntax match asemeDeclaration_205 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_206 skipwhite skipempty
syntax region asemeComment_206 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_206 skipwhite skipempty
syntax match asemeComment_206 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_206 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_204
syntax region asemePunctuation_204 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_202,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_202 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_201,asemeComment_203 skipwhite skipempty
syntax region asemeComment_203 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_201,asemeComment_203 skipwhite skipempty
syntax match asemeComment_203 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_201,asemeComment_203 skipwhite skipempty
syntax match asemeBlock_201 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_200 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_198,asemeBlock_199
syntax match asemeBlock_199 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_200 skipwhite skipempty
syntax region asemeComment_200 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_200 skipwhite skipempty
syntax match asemeComment_200 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_200 skipwhite skipempty
syntax region asemePunctuation_198 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_196,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_196 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_195,asemeComment_197 skipwhite skipempty
syntax region asemeComment_197 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_195,asemeComment_197 skipwhite skipempty
syntax match asemeComment_197 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_195,asemeComment_197 skipwhite skipempty
syntax match asemeName_195 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_185,asemeClause_188,asemePunctuation_191,asemeText_193,asemeName_194
syntax match asemeName_194 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax match asemeText_193 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax match asemePunctuation_191 /\v\,/ contained nextgroup=asemeReference_190,asemeComment_192 skipwhite skipempty
syntax region asemeComment_192 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_190,asemeComment_192 skipwhite skipempty
syntax match asemeComment_192 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_190,asemeComment_192 skipwhite skipempty
syntax match asemeReference_190 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax match asemeClause_188 /\von%(<|>)/ contained nextgroup=asemeReference_187,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_187,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_187,asemeComment_189 skipwhite skipempty
syntax match asemeReference_187 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax match asemeClause_185 /\vdepends%(<|>)/ contained nextgroup=asemeClause_183,asemeComment_186 skipwhite skipempty
syntax region asemeComment_186 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_183,asemeComment_186 skipwhite skipempty
syntax match asemeComment_186 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_183,asemeComment_186 skipwhite skipempty
syntax match asemeClause_183 /\von%(<|>)/ contained nextgroup=asemeReference_181,asemeComment_184 skipwhite skipempty
syntax region asemeComment_184 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_181,asemeComment_184 skipwhite skipempty
syntax match asemeComment_184 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_181,asemeComment_184 skipwhite skipempty
syntax match asemeReference_181 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax region asemeComment_182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax match asemeComment_182 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_182 skipwhite skipempty
syntax match asemeDeclaration_179 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_177,asemeComment_180 skipwhite skipempty
syntax region asemeComment_180 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_177,asemeComment_180 skipwhite skipempty
syntax match asemeComment_180 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_177,asemeComment_180 skipwhite skipempty
syntax match asemeName_177 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_176,asemeComment_178 skipwhite skipempty
syntax region asemeComment_178 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_176,asemeComment_178 skipwhite skipempty
syntax match asemeComment_178 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_176,asemeComment_178 skipwhite skipempty
syntax match asemePunctuation_176 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_149,asemePunctuation_157,asemePunctuation_163,asemeOperator_166,asemePunctuation_168,asemeBuiltIn_170,asemeType_172,asemeName_174
syntax match asemeName_174 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_173,asemeComment_175 skipwhite skipempty
syntax region asemeComment_175 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_173,asemeComment_175 skipwhite skipempty
syntax match asemeComment_175 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_173,asemeComment_175 skipwhite skipempty
syntax match asemePunctuation_173 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemeType_172 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_169,asemeComment_171 skipwhite skipempty
syntax match asemeBuiltIn_170 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_169,asemeComment_171 skipwhite skipempty
syntax region asemeComment_171 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_169,asemeComment_171 skipwhite skipempty
syntax match asemeComment_171 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_169,asemeComment_171 skipwhite skipempty
syntax match asemeName_169 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemePunctuation_168 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemeOperator_166 /\v\=%(\=)@!/ contained nextgroup=asemeText_165,asemeComment_167 skipwhite skipempty
syntax region asemeComment_167 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_165,asemeComment_167 skipwhite skipempty
syntax match asemeComment_167 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_165,asemeComment_167 skipwhite skipempty
syntax match asemeText_165 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemePunctuation_163 /\v\,/ contained nextgroup=asemeBuiltIn_160,asemeType_162,asemeComment_164 skipwhite skipempty
syntax region asemeComment_164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_160,asemeType_162,asemeComment_164 skipwhite skipempty
syntax match asemeComment_164 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_160,asemeType_162,asemeComment_164 skipwhite skipempty
syntax match asemeType_162 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_159,asemeComment_161 skipwhite skipempty
syntax match asemeBuiltIn_160 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_159,asemeComment_161 skipwhite skipempty
syntax region asemeComment_161 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_159,asemeComment_161 skipwhite skipempty
syntax match asemeComment_161 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_159,asemeComment_161 skipwhite skipempty
syntax match asemeName_159 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemePunctuation_157 /\v\:/ contained nextgroup=asemeBuiltIn_154,asemeType_156,asemeComment_158 skipwhite skipempty
syntax region asemeComment_158 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_154,asemeType_156,asemeComment_158 skipwhite skipempty
syntax match asemeComment_158 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_154,asemeType_156,asemeComment_158 skipwhite skipempty
syntax match asemeType_156 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_152,asemeComment_155 skipwhite skipempty
syntax match asemeBuiltIn_154 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_152,asemeComment_155 skipwhite skipempty
syntax region asemeComment_155 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_152,asemeComment_155 skipwhite skipempty
syntax match asemeComment_155 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_152,asemeComment_155 skipwhite skipempty
syntax match asemeOperator_152 /\v\=%(\=)@!/ contained nextgroup=asemeText_151,asemeComment_153 skipwhite skipempty
syntax region asemeComment_153 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_151,asemeComment_153 skipwhite skipempty
syntax match asemeComment_153 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_151,asemeComment_153 skipwhite skipempty
syntax match asemeText_151 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemePunctuation_149 /\v\)/ contained nextgroup=asemePunctuation_147,asemeComment_150 skipwhite skipempty
syntax region asemeComment_150 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_147,asemeComment_150 skipwhite skipempty
syntax match asemeComment_150 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_147,asemeComment_150 skipwhite skipempty
syntax match asemePunctuation_147 /\v\:/ contained nextgroup=asemeBuiltIn_144,asemeType_146,asemeComment_148 skipwhite skipempty
syntax region asemeComment_148 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_144,asemeType_146,asemeComment_148 skipwhite skipempty
syntax match asemeComment_148 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_144,asemeType_146,asemeComment_148 skipwhite skipempty
syntax match asemeType_146 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_142,asemeComment_145 skipwhite skipempty
syntax match asemeBuiltIn_144 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_142,asemeComment_145 skipwhite skipempty
syntax region asemeComment_145 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_142,asemeComment_145 skipwhite skipempty
syntax match asemeComment_145 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_142,asemeComment_145 skipwhite skipempty
syntax match asemeOperator_142 /\v\=%(\=)@!/ contained nextgroup=asemeText_140,asemeComment_143 skipwhite skipempty
syntax region asemeComment_143 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_140,asemeComment_143 skipwhite skipempty
syntax match asemeComment_143 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_140,asemeComment_143 skipwhite skipempty
syntax match asemeText_140 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax region asemeComment_141 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemeComment_141 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_141 skipwhite skipempty
syntax match asemeDeclaration_138 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_137,asemeComment_139 skipwhite skipempty
syntax region asemeComment_139 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_137,asemeComment_139 skipwhite skipempty
syntax match asemeComment_139 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_137,asemeComment_139 skipwhite skipempty
syntax match asemeBlock_137 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_112,asemeClause_115,asemeClause_118,asemePunctuation_135,asemeBlock_136
syntax match asemeBlock_136 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
syntax region asemePunctuation_135 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_133,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_133 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_132,asemeComment_134 skipwhite skipempty
syntax region asemeComment_134 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_132,asemeComment_134 skipwhite skipempty
syntax match asemeComment_134 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_132,asemeComment_134 skipwhite skipempty
syntax match asemeReference_132 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_122,asemeClause_125,asemeChoice_127,asemePunctuation_129,asemeReference_131
syntax match asemeReference_131 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax match asemePunctuation_129 /\v\,/ contained nextgroup=asemeReference_128,asemeComment_130 skipwhite skipempty
syntax region asemeComment_130 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_128,asemeComment_130 skipwhite skipempty
syntax match asemeComment_130 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_128,asemeComment_130 skipwhite skipempty
syntax match asemeReference_128 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax match asemeChoice_127 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax match asemeClause_125 /\vevery%(<|>)/ contained nextgroup=asemeNumber_124,asemeComment_126 skipwhite skipempty
syntax region asemeComment_126 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_124,asemeComment_126 skipwhite skipempty
syntax match asemeComment_126 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_124,asemeComment_126 skipwhite skipempty
syntax match asemeNumber_124 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax match asemeClause_122 /\vfrom%(<|>)/ contained nextgroup=asemeReference_120,asemeComment_123 skipwhite skipempty
syntax region asemeComment_123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_120,asemeComment_123 skipwhite skipempty
syntax match asemeComment_123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_120,asemeComment_123 skipwhite skipempty
syntax match asemeReference_120 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax region asemeComment_121 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax match asemeComment_121 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_121 skipwhite skipempty
syntax match asemeClause_118 /\vdelay%(<|>)/ contained nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax region asemeComment_119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax match asemeComment_119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_117,asemeComment_119 skipwhite skipempty
syntax match asemeNumber_117 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_111 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_1180,asemeClause_1183,asemeText_1185,asemeNumber_1186,asemeTruth_1187,asemeLogic_1188,asemeClause_1189,asemeClause_1190,asemeClause_1191,asemeClause_1192,asemeClause_1193,asemeClause_1194,asemeClause_1195,asemeClause_1196,asemeClause_1197,asemeClause_1198,asemeClause_1199,asemeClause_1200,asemeCall_1201,asemeReference_1202,asemeOperator_1203,asemePunctuation_1204
syntax match asemePunctuation_1204 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeOperator_1203 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeReference_1202 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeCall_1201 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1200 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1199 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1198 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1197 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1196 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1195 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1194 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1193 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1192 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1191 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1190 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1189 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeLogic_1188 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeTruth_1187 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeNumber_1186 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeText_1185 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeClause_1183 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1182,asemeComment_1184 skipwhite skipempty
syntax region asemeComment_1184 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1182,asemeComment_1184 skipwhite skipempty
syntax match asemeComment_1184 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1182,asemeComment_1184 skipwhite skipempty
syntax match asemeReference_1182 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1175,asemeComment_1177 skipwhite skipempty
syntax match asemeClause_1180 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1178,asemeComment_1181 skipwhite skipempty
syntax region asemeComment_1181 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1178,asemeComment_1181 skipwhite skipempty
syntax match asemeComment_1181 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1178,asemeComment_1181 skipwhite skipempty
syntax match asemeReference_1178 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1176,asemeComment_1179 skipwhite skipempty
syntax region asemeComment_1179 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1176,asemeComment_1179 skipwhite skipempty
syntax match asemeComment_1179 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1176,asemeComment_1179 skipwhite skipempty
syntax match asemeReference_1176 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1175,asemeComment_1177 skipwhite skipempty
syntax region asemeComment_1177 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1175,asemeComment_1177 skipwhite skipempty
syntax match asemeComment_1177 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1175,asemeComment_1177 skipwhite skipempty
syntax region asemePunctuation_1175 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax region asemeComment_1174 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax match asemeComment_1174 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1174 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_1117,asemeClause_1120,asemeText_1122,asemeNumber_1123,asemeTruth_1124,asemeLogic_1125,asemeClause_1126,asemeClause_1127,asemeClause_1128,asemeClause_1129,asemeClause_1130,asemeClause_1131,asemeClause_1132,asemeClause_1133,asemeClause_1134,asemeClause_1135,asemeClause_1136,asemeClause_1137,asemeCall_1138,asemeReference_1139,asemeOperator_1140,asemePunctuation_1141
syntax match asemePunctuation_1141 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeOperator_1140 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeReference_1139 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeCall_1138 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1137 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1136 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1135 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1134 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1133 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1132 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1131 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1130 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1129 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1128 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1127 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1126 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeLogic_1125 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeTruth_1124 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeNumber_1123 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeText_1122 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeClause_1120 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1119,asemeComment_1121 skipwhite skipempty
syntax region asemeComment_1121 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1119,asemeComment_1121 skipwhite skipempty
syntax match asemeComment_1121 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1119,asemeComment_1121 skipwhite skipempty
syntax match asemeReference_1119 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1112,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1117 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1115,asemeComment_1118 skipwhite skipempty
syntax region asemeComment_1118 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1115,asemeComment_1118 skipwhite skipempty
syntax match asemeComment_1118 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1115,asemeComment_1118 skipwhite skipempty
syntax match asemeReference_1115 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1113,asemeComment_1116 skipwhite skipempty
syntax region asemeComment_1116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1113,asemeComment_1116 skipwhite skipempty
syntax match asemeComment_1116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1113,asemeComment_1116 skipwhite skipempty
syntax match asemeReference_1113 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1112,asemeComment_1114 skipwhite skipempty
syntax region asemeComment_1114 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1112,asemeComment_1114 skipwhite skipempty
syntax match asemeComment_1114 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1112,asemeComment_1114 skipwhite skipempty
syntax region asemePunctuation_1112 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax region asemeComment_1111 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax match asemeComment_1111 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1111 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_1076,asemeClause_1079,asemeText_1081,asemeNumber_1082,asemeTruth_1083,asemeLogic_1084,asemeClause_1085,asemeClause_1086,asemeClause_1087,asemeClause_1088,asemeClause_1089,asemeClause_1090,asemeClause_1091,asemeClause_1092,asemeClause_1093,asemeClause_1094,asemeClause_1095,asemeClause_1096,asemeCall_1097,asemeReference_1098,asemeOperator_1099,asemePunctuation_1100
syntax match asemePunctuation_1100 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeOperator_1099 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeReference_1098 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeCall_1097 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1096 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1095 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1094 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1093 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1092 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1091 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1090 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1089 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1088 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1087 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1086 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1085 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeLogic_1084 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeTruth_1083 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeNumber_1082 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeText_1081 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeClause_1079 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1078,asemeComment_1080 skipwhite skipempty
syntax region asemeComment_1080 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1078,asemeComment_1080 skipwhite skipempty
syntax match asemeComment_1080 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1078,asemeComment_1080 skipwhite skipempty
syntax match asemeReference_1078 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1071,asemeComment_1073 skipwhite skipempty
syntax match asemeClause_1076 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1074,asemeComment_1077 skipwhite skipempty
syntax region asemeComment_1077 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1074,asemeComment_1077 skipwhite skipempty
syntax match asemeComment_1077 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1074,asemeComment_1077 skipwhite skipempty
syntax match asemeReference_1074 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1072,asemeComment_1075 skipwhite skipempty
syntax region asemeComment_1075 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1072,asemeComment_1075 skipwhite skipempty
syntax match asemeComment_1075 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1072,asemeComment_1075 skipwhite skipempty
syntax match asemeReference_1072 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1071,asemeComment_1073 skipwhite skipempty
syntax region asemeComment_1073 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1071,asemeComment_1073 skipwhite skipempty
syntax match asemeComment_1073 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1071,asemeComment_1073 skipwhite skipempty
syntax region asemePunctuation_1071 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax region asemeComment_1070 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax match asemeComment_1070 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1070 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_867,asemeNumber_869,asemeReference_870,asemeNumber_871,asemeOperator_872,asemePunctuation_873
syntax match asemePunctuation_873 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemeOperator_872 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemeNumber_871 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemeReference_870 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemeNumber_869 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemeText_867 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax region asemeComment_868 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax match asemeComment_868 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_868 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_808,asemeClause_811,asemeText_813,asemeNumber_814,asemeTruth_815,asemeLogic_816,asemeClause_817,asemeClause_818,asemeClause_819,asemeClause_820,asemeClause_821,asemeClause_822,asemeClause_823,asemeClause_824,asemeClause_825,asemeClause_826,asemeClause_827,asemeClause_828,asemeCall_829,asemeReference_830,asemeOperator_831,asemePunctuation_832
syntax match asemePunctuation_832 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeOperator_831 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeReference_830 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeCall_829 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_828 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_827 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_826 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_825 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_824 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_823 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_822 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_821 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_820 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_819 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_818 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_817 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeLogic_816 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeTruth_815 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeNumber_814 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeText_813 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeClause_811 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_810,asemeComment_812 skipwhite skipempty
syntax region asemeComment_812 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_810,asemeComment_812 skipwhite skipempty
syntax match asemeComment_812 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_810,asemeComment_812 skipwhite skipempty
syntax match asemeReference_810 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_803,asemeComment_805 skipwhite skipempty
syntax match asemeClause_808 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_806,asemeComment_809 skipwhite skipempty
syntax region asemeComment_809 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_806,asemeComment_809 skipwhite skipempty
syntax match asemeComment_809 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_806,asemeComment_809 skipwhite skipempty
syntax match asemeReference_806 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_804,asemeComment_807 skipwhite skipempty
syntax region asemeComment_807 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_804,asemeComment_807 skipwhite skipempty
syntax match asemeComment_807 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_804,asemeComment_807 skipwhite skipempty
syntax match asemeReference_804 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_803,asemeComment_805 skipwhite skipempty
syntax region asemeComment_805 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_803,asemeComment_805 skipwhite skipempty
syntax match asemeComment_805 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_803,asemeComment_805 skipwhite skipempty
syntax region asemePunctuation_803 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax region asemeComment_802 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax match asemeComment_802 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_802 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfSrm contains=asemeReference_731,asemeText_733,asemeNumber_734,asemeTruth_735,asemeLogic_736,asemeClause_737,asemeClause_738,asemeClause_739,asemeClause_740,asemeClause_741,asemeClause_742,asemeClause_743,asemeClause_744,asemeClause_745,asemeClause_746,asemeClause_747,asemeClause_748,asemeCall_749,asemeReference_750,asemeOperator_751,asemePunctuation_752
syntax match asemePunctuation_752 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeOperator_751 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeReference_750 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeCall_749 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_748 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_747 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_746 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_745 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_744 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_743 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_742 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_741 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_740 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_739 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_738 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeClause_737 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeLogic_736 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeTruth_735 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeNumber_734 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeText_733 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeReference_731 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_729,asemeComment_732 skipwhite skipempty
syntax region asemeComment_732 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_729,asemeComment_732 skipwhite skipempty
syntax match asemeComment_732 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_729,asemeComment_732 skipwhite skipempty
syntax match asemeReference_729 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_728,asemeComment_730 skipwhite skipempty
syntax region asemeComment_730 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_728,asemeComment_730 skipwhite skipempty
syntax match asemeComment_730 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_728,asemeComment_730 skipwhite skipempty
syntax region asemePunctuation_728 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax region asemeComment_727 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax match asemeComment_727 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_727 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfSrm contains=asemeClause_693,asemeClause_696,asemeText_698,asemeNumber_699,asemeTruth_700,asemeLogic_701,asemeClause_702,asemeClause_703,asemeClause_704,asemeClause_705,asemeClause_706,asemeClause_707,asemeClause_708,asemeClause_709,asemeClause_710,asemeClause_711,asemeClause_712,asemeClause_713,asemeCall_714,asemeReference_715,asemeOperator_716,asemePunctuation_717
syntax match asemePunctuation_717 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeOperator_716 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeReference_715 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeCall_714 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_713 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_712 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_711 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_710 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_709 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_708 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_707 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_706 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_705 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_704 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_703 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_702 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeLogic_701 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeTruth_700 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeNumber_699 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeText_698 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeClause_696 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_695,asemeComment_697 skipwhite skipempty
syntax region asemeComment_697 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_695,asemeComment_697 skipwhite skipempty
syntax match asemeComment_697 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_695,asemeComment_697 skipwhite skipempty
syntax match asemeReference_695 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax match asemeClause_693 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_691,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_691,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_691,asemeComment_694 skipwhite skipempty
syntax match asemeReference_691 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_689,asemeComment_692 skipwhite skipempty
syntax region asemeComment_692 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_689,asemeComment_692 skipwhite skipempty
syntax match asemeComment_692 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_689,asemeComment_692 skipwhite skipempty
syntax match asemeReference_689 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax region asemeComment_690 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax match asemeComment_690 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_688,asemeComment_690 skipwhite skipempty
syntax region asemePunctuation_688 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax region asemeComment_687 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeComment_687 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_621,asemeClause_624,asemeText_626,asemeNumber_627,asemeTruth_628,asemeLogic_629,asemeClause_630,asemeClause_631,asemeClause_632,asemeClause_633,asemeClause_634,asemeClause_635,asemeClause_636,asemeClause_637,asemeClause_638,asemeClause_639,asemeClause_640,asemeClause_641,asemeCall_642,asemeReference_643,asemeOperator_644,asemePunctuation_645
syntax match asemePunctuation_645 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeOperator_644 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeReference_643 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeCall_642 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_641 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_640 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_639 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_638 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_637 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_636 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_635 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_634 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_633 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_632 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_631 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_630 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeLogic_629 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeTruth_628 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeNumber_627 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeText_626 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeClause_624 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_623,asemeComment_625 skipwhite skipempty
syntax region asemeComment_625 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_623,asemeComment_625 skipwhite skipempty
syntax match asemeComment_625 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_623,asemeComment_625 skipwhite skipempty
syntax match asemeReference_623 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax match asemeClause_621 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_619,asemeComment_622 skipwhite skipempty
syntax region asemeComment_622 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_619,asemeComment_622 skipwhite skipempty
syntax match asemeComment_622 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_619,asemeComment_622 skipwhite skipempty
syntax match asemeReference_619 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_617,asemeComment_620 skipwhite skipempty
syntax region asemeComment_620 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_617,asemeComment_620 skipwhite skipempty
syntax match asemeComment_620 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_617,asemeComment_620 skipwhite skipempty
syntax match asemeReference_617 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax region asemeComment_618 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax match asemeComment_618 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax region asemePunctuation_616 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax region asemeComment_615 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax match asemeComment_615 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_615 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_582,asemeClause_585,asemeText_587,asemeNumber_588,asemeTruth_589,asemeLogic_590,asemeClause_591,asemeClause_592,asemeClause_593,asemeClause_594,asemeClause_595,asemeClause_596,asemeClause_597,asemeClause_598,asemeClause_599,asemeClause_600,asemeClause_601,asemeClause_602,asemeCall_603,asemeReference_604,asemeOperator_605,asemePunctuation_606
syntax match asemePunctuation_606 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeOperator_605 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeReference_604 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeCall_603 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_602 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_601 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_600 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_599 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_598 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_597 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_596 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_595 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_594 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_593 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_592 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_591 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeLogic_590 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeTruth_589 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeNumber_588 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeText_587 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeClause_585 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_584,asemeComment_586 skipwhite skipempty
syntax region asemeComment_586 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_584,asemeComment_586 skipwhite skipempty
syntax match asemeComment_586 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_584,asemeComment_586 skipwhite skipempty
syntax match asemeReference_584 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_577,asemeComment_579 skipwhite skipempty
syntax match asemeClause_582 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_580,asemeComment_583 skipwhite skipempty
syntax region asemeComment_583 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_580,asemeComment_583 skipwhite skipempty
syntax match asemeComment_583 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_580,asemeComment_583 skipwhite skipempty
syntax match asemeReference_580 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_578,asemeComment_581 skipwhite skipempty
syntax region asemeComment_581 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_578,asemeComment_581 skipwhite skipempty
syntax match asemeComment_581 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_578,asemeComment_581 skipwhite skipempty
syntax match asemeReference_578 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_577,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_577,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_577,asemeComment_579 skipwhite skipempty
syntax region asemePunctuation_577 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax region asemeComment_576 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax match asemeComment_576 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_576 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_511,asemeNumber_513,asemeReference_514,asemeNumber_515,asemeOperator_516,asemePunctuation_517
syntax match asemePunctuation_517 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeOperator_516 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeNumber_515 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeReference_514 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeNumber_513 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeText_511 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax region asemeComment_512 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax match asemeComment_512 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_512 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant contains=asemeClause_417,asemeClause_420,asemeText_422,asemeNumber_423,asemeTruth_424,asemeLogic_425,asemeClause_426,asemeClause_427,asemeClause_428,asemeClause_429,asemeClause_430,asemeClause_431,asemeClause_432,asemeClause_433,asemeClause_434,asemeClause_435,asemeClause_436,asemeClause_437,asemeCall_438,asemeReference_439,asemeOperator_440,asemePunctuation_441
syntax match asemePunctuation_441 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeOperator_440 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeReference_439 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeCall_438 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_437 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_436 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_435 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_434 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_433 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_432 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_431 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_430 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_429 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_428 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_427 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_426 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeLogic_425 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeTruth_424 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeNumber_423 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeText_422 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeClause_420 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_419,asemeComment_421 skipwhite skipempty
syntax region asemeComment_421 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_419,asemeComment_421 skipwhite skipempty
syntax match asemeComment_421 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_419,asemeComment_421 skipwhite skipempty
syntax match asemeReference_419 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_412,asemeComment_414 skipwhite skipempty
syntax match asemeClause_417 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_415,asemeComment_418 skipwhite skipempty
syntax region asemeComment_418 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_415,asemeComment_418 skipwhite skipempty
syntax match asemeComment_418 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_415,asemeComment_418 skipwhite skipempty
syntax match asemeReference_415 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_413,asemeComment_416 skipwhite skipempty
syntax region asemeComment_416 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_413,asemeComment_416 skipwhite skipempty
syntax match asemeComment_416 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_413,asemeComment_416 skipwhite skipempty
syntax match asemeReference_413 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_412,asemeComment_414 skipwhite skipempty
syntax region asemeComment_414 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_412,asemeComment_414 skipwhite skipempty
syntax match asemeComment_414 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_412,asemeComment_414 skipwhite skipempty
syntax region asemePunctuation_412 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax region asemeComment_411 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax match asemeComment_411 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_411 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_356,asemeClause_359,asemeText_361,asemeNumber_362,asemeTruth_363,asemeLogic_364,asemeClause_365,asemeClause_366,asemeClause_367,asemeClause_368,asemeClause_369,asemeClause_370,asemeClause_371,asemeClause_372,asemeClause_373,asemeClause_374,asemeClause_375,asemeClause_376,asemeCall_377,asemeReference_378,asemeOperator_379,asemePunctuation_380
syntax match asemePunctuation_380 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeOperator_379 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeReference_378 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeCall_377 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_376 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_375 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_374 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_373 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_372 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_371 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_370 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_369 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_368 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_367 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_366 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_365 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeLogic_364 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeTruth_363 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeNumber_362 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeText_361 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeClause_359 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_358,asemeComment_360 skipwhite skipempty
syntax region asemeComment_360 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_358,asemeComment_360 skipwhite skipempty
syntax match asemeComment_360 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_358,asemeComment_360 skipwhite skipempty
syntax match asemeReference_358 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_351,asemeComment_353 skipwhite skipempty
syntax match asemeClause_356 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_354,asemeComment_357 skipwhite skipempty
syntax region asemeComment_357 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_354,asemeComment_357 skipwhite skipempty
syntax match asemeComment_357 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_354,asemeComment_357 skipwhite skipempty
syntax match asemeReference_354 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_352,asemeComment_355 skipwhite skipempty
syntax region asemeComment_355 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_352,asemeComment_355 skipwhite skipempty
syntax match asemeComment_355 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_352,asemeComment_355 skipwhite skipempty
syntax match asemeReference_352 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_351,asemeComment_353 skipwhite skipempty
syntax region asemeComment_353 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_351,asemeComment_353 skipwhite skipempty
syntax match asemeComment_353 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_351,asemeComment_353 skipwhite skipempty
syntax region asemePunctuation_351 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax region asemeComment_350 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax match asemeComment_350 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_350 skipwhite skipempty
syntax cluster asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeReference_295,asemeText_297,asemeNumber_298,asemeTruth_299,asemeLogic_300,asemeClause_301,asemeClause_302,asemeClause_303,asemeClause_304,asemeClause_305,asemeClause_306,asemeClause_307,asemeClause_308,asemeClause_309,asemeClause_310,asemeClause_311,asemeClause_312,asemeCall_313,asemeReference_314,asemeOperator_315,asemePunctuation_316
syntax match asemePunctuation_316 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeOperator_315 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeReference_314 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeCall_313 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_312 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_311 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_310 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_309 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_308 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_307 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_306 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_305 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_304 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_303 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_302 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=when%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeClause_301 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=else%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeLogic_300 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeTruth_299 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeNumber_298 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeText_297 /\v%(%(%(%(%(%(liveness|activities|modules)\_s*\{|%(engage|var|let|sends|receives|includes|capability|functionality|control)\_s+\w|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!)@!|\{%(\"%([^"\\\n]|\\.)*\"|[^{}"])*\})))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeReference_295 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_293,asemeComment_296 skipwhite skipempty
syntax region asemeComment_296 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_293,asemeComment_296 skipwhite skipempty
syntax match asemeComment_296 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_293,asemeComment_296 skipwhite skipempty
syntax match asemeReference_293 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_292,asemeComment_294 skipwhite skipempty
syntax region asemeComment_294 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_292,asemeComment_294 skipwhite skipempty
syntax match asemeComment_294 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_292,asemeComment_294 skipwhite skipempty
syntax region asemePunctuation_292 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax region asemeComment_291 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax match asemeComment_291 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBusyTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_291 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeClause_257,asemeClause_260,asemeText_262,asemeNumber_263,asemeTruth_264,asemeLogic_265,asemeClause_266,asemeClause_267,asemeClause_268,asemeClause_269,asemeClause_270,asemeClause_271,asemeClause_272,asemeClause_273,asemeClause_274,asemeClause_275,asemeClause_276,asemeClause_277,asemeCall_278,asemeReference_279,asemeOperator_280,asemePunctuation_281
syntax match asemePunctuation_281 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeOperator_280 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeReference_279 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeCall_278 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_277 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_276 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_275 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_274 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_273 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_272 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_271 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_270 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_269 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_268 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_267 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_266 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeLogic_265 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeTruth_264 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeNumber_263 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeText_262 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|when\_s+busy%(<|>)|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc|when)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_260 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_259,asemeComment_261 skipwhite skipempty
syntax region asemeComment_261 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_259,asemeComment_261 skipwhite skipempty
syntax match asemeComment_261 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_259,asemeComment_261 skipwhite skipempty
syntax match asemeReference_259 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_252,asemeComment_254 skipwhite skipempty
syntax match asemeClause_257 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_255,asemeComment_258 skipwhite skipempty
syntax region asemeComment_258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_255,asemeComment_258 skipwhite skipempty
syntax match asemeComment_258 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_255,asemeComment_258 skipwhite skipempty
syntax match asemeReference_255 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax region asemeComment_256 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax match asemeComment_256 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax match asemeReference_253 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_252,asemeComment_254 skipwhite skipempty
syntax region asemeComment_254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_252,asemeComment_254 skipwhite skipempty
syntax match asemeComment_254 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_252,asemeComment_254 skipwhite skipempty
syntax region asemePunctuation_252 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax region asemeComment_251 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeComment_251 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax cluster asemeLet contains=asemeClause_42,asemeClause_45,asemeText_47,asemeNumber_48,asemeTruth_49,asemeLogic_50,asemeClause_51,asemeClause_52,asemeClause_53,asemeClause_54,asemeClause_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeClause_59,asemeClause_60,asemeClause_61,asemeClause_62,asemeCall_63,asemeReference_64,asemeOperator_65,asemePunctuation_66
syntax match asemePunctuation_66 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeOperator_65 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeReference_64 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeCall_63 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeClause_51 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeLogic_50 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeTruth_49 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeNumber_48 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeText_47 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
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
syntax match asemeOperator_28 /\v%([^ \t{}])@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
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
highlight default link asemeBlock_1005 asemeBlock
highlight default link asemeBlock_1007 asemeBlock
highlight default link asemeBlock_1019 asemeBlock
highlight default link asemeBlock_1025 asemeBlock
highlight default link asemeBlock_1030 asemeBlock
highlight default link asemeBlock_1031 asemeBlock
highlight default link asemeBlock_1036 asemeBlock
highlight default link asemeBlock_105 asemeBlock
highlight default link asemeBlock_107 asemeBlock
highlight default link asemeBlock_1169 asemeBlock
highlight default link asemeBlock_1171 asemeBlock
highlight default link asemeBlock_1238 asemeBlock
highlight default link asemeBlock_1240 asemeBlock
highlight default link asemeBlock_136 asemeBlock
highlight default link asemeBlock_137 asemeBlock
highlight default link asemeBlock_199 asemeBlock
highlight default link asemeBlock_201 asemeBlock
highlight default link asemeBlock_521 asemeBlock
highlight default link asemeBlock_522 asemeBlock
highlight default link asemeBlock_659 asemeBlock
highlight default link asemeBlock_665 asemeBlock
highlight default link asemeBlock_670 asemeBlock
highlight default link asemeBlock_672 asemeBlock
highlight default link asemeBlock_675 asemeBlock
highlight default link asemeBlock_79 asemeBlock
highlight default link asemeBlock_81 asemeBlock
highlight default link asemeBuiltIn_101 asemeBuiltIn
highlight default link asemeBuiltIn_1106 asemeBuiltIn
highlight default link asemeBuiltIn_1143 asemeBuiltIn
highlight default link asemeBuiltIn_1149 asemeBuiltIn
highlight default link asemeBuiltIn_1151 asemeBuiltIn
highlight default link asemeBuiltIn_144 asemeBuiltIn
highlight default link asemeBuiltIn_154 asemeBuiltIn
highlight default link asemeBuiltIn_160 asemeBuiltIn
highlight default link asemeBuiltIn_170 asemeBuiltIn
highlight default link asemeBuiltIn_345 asemeBuiltIn
highlight default link asemeBuiltIn_382 asemeBuiltIn
highlight default link asemeBuiltIn_388 asemeBuiltIn
highlight default link asemeBuiltIn_390 asemeBuiltIn
highlight default link asemeBuiltIn_398 asemeBuiltIn
highlight default link asemeBuiltIn_406 asemeBuiltIn
highlight default link asemeBuiltIn_443 asemeBuiltIn
highlight default link asemeBuiltIn_449 asemeBuiltIn
highlight default link asemeBuiltIn_451 asemeBuiltIn
highlight default link asemeBuiltIn_503 asemeBuiltIn
highlight default link asemeBuiltIn_797 asemeBuiltIn
highlight default link asemeBuiltIn_834 asemeBuiltIn
highlight default link asemeBuiltIn_840 asemeBuiltIn
highlight default link asemeBuiltIn_842 asemeBuiltIn
highlight default link asemeBuiltIn_859 asemeBuiltIn
highlight default link asemeBuiltIn_90 asemeBuiltIn
highlight default link asemeBuiltIn_916 asemeBuiltIn
highlight default link asemeBuiltIn_924 asemeBuiltIn
highlight default link asemeBuiltIn_938 asemeBuiltIn
highlight default link asemeBuiltIn_95 asemeBuiltIn
highlight default link asemeCall_1097 asemeCall
highlight default link asemeCall_1138 asemeCall
highlight default link asemeCall_1201 asemeCall
highlight default link asemeCall_26 asemeCall
highlight default link asemeCall_278 asemeCall
highlight default link asemeCall_313 asemeCall
highlight default link asemeCall_377 asemeCall
highlight default link asemeCall_438 asemeCall
highlight default link asemeCall_603 asemeCall
highlight default link asemeCall_63 asemeCall
highlight default link asemeCall_642 asemeCall
highlight default link asemeCall_714 asemeCall
highlight default link asemeCall_749 asemeCall
highlight default link asemeCall_829 asemeCall
highlight default link asemeChoice_1045 asemeChoice
highlight default link asemeChoice_1049 asemeChoice
highlight default link asemeChoice_1057 asemeChoice
highlight default link asemeChoice_127 asemeChoice
highlight default link asemeChoice_207 asemeChoice
highlight default link asemeChoice_212 asemeChoice
highlight default link asemeChoice_528 asemeChoice
highlight default link asemeChoice_535 asemeChoice
highlight default link asemeChoice_881 asemeChoice
highlight default link asemeChoice_895 asemeChoice
highlight default link asemeChoice_902 asemeChoice
highlight default link asemeChoice_914 asemeChoice
highlight default link asemeChoice_915 asemeChoice
highlight default link asemeChoice_931 asemeChoice
highlight default link asemeChoice_950 asemeChoice
highlight default link asemeChoice_964 asemeChoice
highlight default link asemeChoice_971 asemeChoice
highlight default link asemeChoice_983 asemeChoice
highlight default link asemeChoice_984 asemeChoice
highlight default link asemeChoice_986 asemeChoice
highlight default link asemeClause_1032 asemeClause
highlight default link asemeClause_1041 asemeClause
highlight default link asemeClause_1076 asemeClause
highlight default link asemeClause_1079 asemeClause
highlight default link asemeClause_1085 asemeClause
highlight default link asemeClause_1086 asemeClause
highlight default link asemeClause_1087 asemeClause
highlight default link asemeClause_1088 asemeClause
highlight default link asemeClause_1089 asemeClause
highlight default link asemeClause_1090 asemeClause
highlight default link asemeClause_1091 asemeClause
highlight default link asemeClause_1092 asemeClause
highlight default link asemeClause_1093 asemeClause
highlight default link asemeClause_1094 asemeClause
highlight default link asemeClause_1095 asemeClause
highlight default link asemeClause_1096 asemeClause
highlight default link asemeClause_1117 asemeClause
highlight default link asemeClause_112 asemeClause
highlight default link asemeClause_1120 asemeClause
highlight default link asemeClause_1126 asemeClause
highlight default link asemeClause_1127 asemeClause
highlight default link asemeClause_1128 asemeClause
highlight default link asemeClause_1129 asemeClause
highlight default link asemeClause_1130 asemeClause
highlight default link asemeClause_1131 asemeClause
highlight default link asemeClause_1132 asemeClause
highlight default link asemeClause_1133 asemeClause
highlight default link asemeClause_1134 asemeClause
highlight default link asemeClause_1135 asemeClause
highlight default link asemeClause_1136 asemeClause
highlight default link asemeClause_1137 asemeClause
highlight default link asemeClause_115 asemeClause
highlight default link asemeClause_118 asemeClause
highlight default link asemeClause_1180 asemeClause
highlight default link asemeClause_1183 asemeClause
highlight default link asemeClause_1189 asemeClause
highlight default link asemeClause_1190 asemeClause
highlight default link asemeClause_1191 asemeClause
highlight default link asemeClause_1192 asemeClause
highlight default link asemeClause_1193 asemeClause
highlight default link asemeClause_1194 asemeClause
highlight default link asemeClause_1195 asemeClause
highlight default link asemeClause_1196 asemeClause
highlight default link asemeClause_1197 asemeClause
highlight default link asemeClause_1198 asemeClause
highlight default link asemeClause_1199 asemeClause
highlight default link asemeClause_1200 asemeClause
highlight default link asemeClause_1208 asemeClause
highlight default link asemeClause_122 asemeClause
highlight default link asemeClause_125 asemeClause
highlight default link asemeClause_14 asemeClause
highlight default link asemeClause_15 asemeClause
highlight default link asemeClause_16 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_183 asemeClause
highlight default link asemeClause_185 asemeClause
highlight default link asemeClause_188 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_221 asemeClause
highlight default link asemeClause_224 asemeClause
highlight default link asemeClause_227 asemeClause
highlight default link asemeClause_23 asemeClause
highlight default link asemeClause_24 asemeClause
highlight default link asemeClause_25 asemeClause
highlight default link asemeClause_257 asemeClause
highlight default link asemeClause_260 asemeClause
highlight default link asemeClause_266 asemeClause
highlight default link asemeClause_267 asemeClause
highlight default link asemeClause_268 asemeClause
highlight default link asemeClause_269 asemeClause
highlight default link asemeClause_270 asemeClause
highlight default link asemeClause_271 asemeClause
highlight default link asemeClause_272 asemeClause
highlight default link asemeClause_273 asemeClause
highlight default link asemeClause_274 asemeClause
highlight default link asemeClause_275 asemeClause
highlight default link asemeClause_276 asemeClause
highlight default link asemeClause_277 asemeClause
highlight default link asemeClause_285 asemeClause
highlight default link asemeClause_289 asemeClause
highlight default link asemeClause_301 asemeClause
highlight default link asemeClause_302 asemeClause
highlight default link asemeClause_303 asemeClause
highlight default link asemeClause_304 asemeClause
highlight default link asemeClause_305 asemeClause
highlight default link asemeClause_306 asemeClause
highlight default link asemeClause_307 asemeClause
highlight default link asemeClause_308 asemeClause
highlight default link asemeClause_309 asemeClause
highlight default link asemeClause_310 asemeClause
highlight default link asemeClause_311 asemeClause
highlight default link asemeClause_312 asemeClause
highlight default link asemeClause_317 asemeClause
highlight default link asemeClause_318 asemeClause
highlight default link asemeClause_320 asemeClause
highlight default link asemeClause_356 asemeClause
highlight default link asemeClause_359 asemeClause
highlight default link asemeClause_365 asemeClause
highlight default link asemeClause_366 asemeClause
highlight default link asemeClause_367 asemeClause
highlight default link asemeClause_368 asemeClause
highlight default link asemeClause_369 asemeClause
highlight default link asemeClause_370 asemeClause
highlight default link asemeClause_371 asemeClause
highlight default link asemeClause_372 asemeClause
highlight default link asemeClause_373 asemeClause
highlight default link asemeClause_374 asemeClause
highlight default link asemeClause_375 asemeClause
highlight default link asemeClause_376 asemeClause
highlight default link asemeClause_417 asemeClause
highlight default link asemeClause_42 asemeClause
highlight default link asemeClause_420 asemeClause
highlight default link asemeClause_426 asemeClause
highlight default link asemeClause_427 asemeClause
highlight default link asemeClause_428 asemeClause
highlight default link asemeClause_429 asemeClause
highlight default link asemeClause_430 asemeClause
highlight default link asemeClause_431 asemeClause
highlight default link asemeClause_432 asemeClause
highlight default link asemeClause_433 asemeClause
highlight default link asemeClause_434 asemeClause
highlight default link asemeClause_435 asemeClause
highlight default link asemeClause_436 asemeClause
highlight default link asemeClause_437 asemeClause
highlight default link asemeClause_45 asemeClause
highlight default link asemeClause_466 asemeClause
highlight default link asemeClause_469 asemeClause
highlight default link asemeClause_471 asemeClause
highlight default link asemeClause_51 asemeClause
highlight default link asemeClause_52 asemeClause
highlight default link asemeClause_53 asemeClause
highlight default link asemeClause_531 asemeClause
highlight default link asemeClause_533 asemeClause
highlight default link asemeClause_537 asemeClause
highlight default link asemeClause_54 asemeClause
highlight default link asemeClause_540 asemeClause
highlight default link asemeClause_542 asemeClause
highlight default link asemeClause_543 asemeClause
highlight default link asemeClause_546 asemeClause
highlight default link asemeClause_548 asemeClause
highlight default link asemeClause_549 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_550 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_571 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_582 asemeClause
highlight default link asemeClause_585 asemeClause
highlight default link asemeClause_59 asemeClause
highlight default link asemeClause_591 asemeClause
highlight default link asemeClause_592 asemeClause
highlight default link asemeClause_593 asemeClause
highlight default link asemeClause_594 asemeClause
highlight default link asemeClause_595 asemeClause
highlight default link asemeClause_596 asemeClause
highlight default link asemeClause_597 asemeClause
highlight default link asemeClause_598 asemeClause
highlight default link asemeClause_599 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_600 asemeClause
highlight default link asemeClause_601 asemeClause
highlight default link asemeClause_602 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_621 asemeClause
highlight default link asemeClause_624 asemeClause
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
highlight default link asemeClause_640 asemeClause
highlight default link asemeClause_641 asemeClause
highlight default link asemeClause_677 asemeClause
highlight default link asemeClause_693 asemeClause
highlight default link asemeClause_696 asemeClause
highlight default link asemeClause_702 asemeClause
highlight default link asemeClause_703 asemeClause
highlight default link asemeClause_704 asemeClause
highlight default link asemeClause_705 asemeClause
highlight default link asemeClause_706 asemeClause
highlight default link asemeClause_707 asemeClause
highlight default link asemeClause_708 asemeClause
highlight default link asemeClause_709 asemeClause
highlight default link asemeClause_710 asemeClause
highlight default link asemeClause_711 asemeClause
highlight default link asemeClause_712 asemeClause
highlight default link asemeClause_713 asemeClause
highlight default link asemeClause_721 asemeClause
highlight default link asemeClause_725 asemeClause
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
highlight default link asemeClause_753 asemeClause
highlight default link asemeClause_754 asemeClause
highlight default link asemeClause_756 asemeClause
highlight default link asemeClause_808 asemeClause
highlight default link asemeClause_811 asemeClause
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
highlight default link asemeClause_827 asemeClause
highlight default link asemeClause_828 asemeClause
highlight default link asemeClause_884 asemeClause
highlight default link asemeClause_887 asemeClause
highlight default link asemeClause_890 asemeClause
highlight default link asemeClause_893 asemeClause
highlight default link asemeClause_896 asemeClause
highlight default link asemeClause_899 asemeClause
highlight default link asemeClause_905 asemeClause
highlight default link asemeClause_908 asemeClause
highlight default link asemeClause_911 asemeClause
highlight default link asemeClause_913 asemeClause
highlight default link asemeClause_953 asemeClause
highlight default link asemeClause_956 asemeClause
highlight default link asemeClause_959 asemeClause
highlight default link asemeClause_962 asemeClause
highlight default link asemeClause_965 asemeClause
highlight default link asemeClause_968 asemeClause
highlight default link asemeClause_974 asemeClause
highlight default link asemeClause_977 asemeClause
highlight default link asemeClause_980 asemeClause
highlight default link asemeClause_982 asemeClause
highlight default link asemeComment_1000 asemeComment
highlight default link asemeComment_1003 asemeComment
highlight default link asemeComment_1006 asemeComment
highlight default link asemeComment_1009 asemeComment
highlight default link asemeComment_1011 asemeComment
highlight default link asemeComment_1013 asemeComment
highlight default link asemeComment_1017 asemeComment
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_1020 asemeComment
highlight default link asemeComment_1023 asemeComment
highlight default link asemeComment_1026 asemeComment
highlight default link asemeComment_1028 asemeComment
highlight default link asemeComment_1033 asemeComment
highlight default link asemeComment_1035 asemeComment
highlight default link asemeComment_1038 asemeComment
highlight default link asemeComment_1040 asemeComment
highlight default link asemeComment_1042 asemeComment
highlight default link asemeComment_1046 asemeComment
highlight default link asemeComment_1050 asemeComment
highlight default link asemeComment_1052 asemeComment
highlight default link asemeComment_1058 asemeComment
highlight default link asemeComment_106 asemeComment
highlight default link asemeComment_1060 asemeComment
highlight default link asemeComment_1062 asemeComment
highlight default link asemeComment_1065 asemeComment
highlight default link asemeComment_1067 asemeComment
highlight default link asemeComment_1069 asemeComment
highlight default link asemeComment_1070 asemeComment
highlight default link asemeComment_1073 asemeComment
highlight default link asemeComment_1075 asemeComment
highlight default link asemeComment_1077 asemeComment
highlight default link asemeComment_1080 asemeComment
highlight default link asemeComment_109 asemeComment
highlight default link asemeComment_1103 asemeComment
highlight default link asemeComment_1105 asemeComment
highlight default link asemeComment_1107 asemeComment
highlight default link asemeComment_111 asemeComment
highlight default link asemeComment_1110 asemeComment
highlight default link asemeComment_1111 asemeComment
highlight default link asemeComment_1114 asemeComment
highlight default link asemeComment_1116 asemeComment
highlight default link asemeComment_1118 asemeComment
highlight default link asemeComment_1121 asemeComment
highlight default link asemeComment_113 asemeComment
highlight default link asemeComment_1146 asemeComment
highlight default link asemeComment_1148 asemeComment
highlight default link asemeComment_1154 asemeComment
highlight default link asemeComment_1156 asemeComment
highlight default link asemeComment_1158 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_1161 asemeComment
highlight default link asemeComment_1163 asemeComment
highlight default link asemeComment_1165 asemeComment
highlight default link asemeComment_1167 asemeComment
highlight default link asemeComment_1170 asemeComment
highlight default link asemeComment_1173 asemeComment
highlight default link asemeComment_1174 asemeComment
highlight default link asemeComment_1177 asemeComment
highlight default link asemeComment_1179 asemeComment
highlight default link asemeComment_1181 asemeComment
highlight default link asemeComment_1184 asemeComment
highlight default link asemeComment_119 asemeComment
highlight default link asemeComment_1207 asemeComment
highlight default link asemeComment_1209 asemeComment
highlight default link asemeComment_121 asemeComment
highlight default link asemeComment_1211 asemeComment
highlight default link asemeComment_1213 asemeComment
highlight default link asemeComment_1215 asemeComment
highlight default link asemeComment_1217 asemeComment
highlight default link asemeComment_1219 asemeComment
highlight default link asemeComment_1222 asemeComment
highlight default link asemeComment_1224 asemeComment
highlight default link asemeComment_1227 asemeComment
highlight default link asemeComment_123 asemeComment
highlight default link asemeComment_1230 asemeComment
highlight default link asemeComment_1233 asemeComment
highlight default link asemeComment_1239 asemeComment
highlight default link asemeComment_1242 asemeComment
highlight default link asemeComment_126 asemeComment
highlight default link asemeComment_1268 asemeComment
highlight default link asemeComment_1271 asemeComment
highlight default link asemeComment_1279 asemeComment
highlight default link asemeComment_1282 asemeComment
highlight default link asemeComment_130 asemeComment
highlight default link asemeComment_134 asemeComment
highlight default link asemeComment_139 asemeComment
highlight default link asemeComment_141 asemeComment
highlight default link asemeComment_143 asemeComment
highlight default link asemeComment_145 asemeComment
highlight default link asemeComment_148 asemeComment
highlight default link asemeComment_150 asemeComment
highlight default link asemeComment_153 asemeComment
highlight default link asemeComment_155 asemeComment
highlight default link asemeComment_158 asemeComment
highlight default link asemeComment_161 asemeComment
highlight default link asemeComment_164 asemeComment
highlight default link asemeComment_167 asemeComment
highlight default link asemeComment_171 asemeComment
highlight default link asemeComment_175 asemeComment
highlight default link asemeComment_178 asemeComment
highlight default link asemeComment_180 asemeComment
highlight default link asemeComment_182 asemeComment
highlight default link asemeComment_184 asemeComment
highlight default link asemeComment_186 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_192 asemeComment
highlight default link asemeComment_197 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_200 asemeComment
highlight default link asemeComment_203 asemeComment
highlight default link asemeComment_206 asemeComment
highlight default link asemeComment_208 asemeComment
highlight default link asemeComment_211 asemeComment
highlight default link asemeComment_214 asemeComment
highlight default link asemeComment_218 asemeComment
highlight default link asemeComment_220 asemeComment
highlight default link asemeComment_222 asemeComment
highlight default link asemeComment_225 asemeComment
highlight default link asemeComment_228 asemeComment
highlight default link asemeComment_231 asemeComment
highlight default link asemeComment_236 asemeComment
highlight default link asemeComment_239 asemeComment
highlight default link asemeComment_241 asemeComment
highlight default link asemeComment_243 asemeComment
highlight default link asemeComment_246 asemeComment
highlight default link asemeComment_250 asemeComment
highlight default link asemeComment_251 asemeComment
highlight default link asemeComment_254 asemeComment
highlight default link asemeComment_256 asemeComment
highlight default link asemeComment_258 asemeComment
highlight default link asemeComment_261 asemeComment
highlight default link asemeComment_284 asemeComment
highlight default link asemeComment_286 asemeComment
highlight default link asemeComment_288 asemeComment
highlight default link asemeComment_290 asemeComment
highlight default link asemeComment_291 asemeComment
highlight default link asemeComment_294 asemeComment
highlight default link asemeComment_296 asemeComment
highlight default link asemeComment_319 asemeComment
highlight default link asemeComment_323 asemeComment
highlight default link asemeComment_326 asemeComment
highlight default link asemeComment_328 asemeComment
highlight default link asemeComment_331 asemeComment
highlight default link asemeComment_335 asemeComment
highlight default link asemeComment_337 asemeComment
highlight default link asemeComment_340 asemeComment
highlight default link asemeComment_342 asemeComment
highlight default link asemeComment_344 asemeComment
highlight default link asemeComment_346 asemeComment
highlight default link asemeComment_349 asemeComment
highlight default link asemeComment_350 asemeComment
highlight default link asemeComment_353 asemeComment
highlight default link asemeComment_355 asemeComment
highlight default link asemeComment_357 asemeComment
highlight default link asemeComment_36 asemeComment
highlight default link asemeComment_360 asemeComment
highlight default link asemeComment_385 asemeComment
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_39 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_395 asemeComment
highlight default link asemeComment_397 asemeComment
highlight default link asemeComment_401 asemeComment
highlight default link asemeComment_403 asemeComment
highlight default link asemeComment_405 asemeComment
highlight default link asemeComment_407 asemeComment
highlight default link asemeComment_41 asemeComment
highlight default link asemeComment_410 asemeComment
highlight default link asemeComment_411 asemeComment
highlight default link asemeComment_414 asemeComment
highlight default link asemeComment_416 asemeComment
highlight default link asemeComment_418 asemeComment
highlight default link asemeComment_421 asemeComment
highlight default link asemeComment_43 asemeComment
highlight default link asemeComment_446 asemeComment
highlight default link asemeComment_448 asemeComment
highlight default link asemeComment_454 asemeComment
highlight default link asemeComment_456 asemeComment
highlight default link asemeComment_458 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_461 asemeComment
highlight default link asemeComment_463 asemeComment
highlight default link asemeComment_465 asemeComment
highlight default link asemeComment_467 asemeComment
highlight default link asemeComment_470 asemeComment
highlight default link asemeComment_474 asemeComment
highlight default link asemeComment_476 asemeComment
highlight default link asemeComment_479 asemeComment
highlight default link asemeComment_482 asemeComment
highlight default link asemeComment_484 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_488 asemeComment
highlight default link asemeComment_490 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_496 asemeComment
highlight default link asemeComment_498 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_500 asemeComment
highlight default link asemeComment_502 asemeComment
highlight default link asemeComment_506 asemeComment
highlight default link asemeComment_509 asemeComment
highlight default link asemeComment_512 asemeComment
highlight default link asemeComment_524 asemeComment
highlight default link asemeComment_527 asemeComment
highlight default link asemeComment_529 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_534 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_544 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_553 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_562 asemeComment
highlight default link asemeComment_564 asemeComment
highlight default link asemeComment_566 asemeComment
highlight default link asemeComment_568 asemeComment
highlight default link asemeComment_570 asemeComment
highlight default link asemeComment_572 asemeComment
highlight default link asemeComment_575 asemeComment
highlight default link asemeComment_576 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_581 asemeComment
highlight default link asemeComment_583 asemeComment
highlight default link asemeComment_586 asemeComment
highlight default link asemeComment_615 asemeComment
highlight default link asemeComment_618 asemeComment
highlight default link asemeComment_620 asemeComment
highlight default link asemeComment_622 asemeComment
highlight default link asemeComment_625 asemeComment
highlight default link asemeComment_648 asemeComment
highlight default link asemeComment_650 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_657 asemeComment
highlight default link asemeComment_660 asemeComment
highlight default link asemeComment_663 asemeComment
highlight default link asemeComment_666 asemeComment
highlight default link asemeComment_668 asemeComment
highlight default link asemeComment_671 asemeComment
highlight default link asemeComment_674 asemeComment
highlight default link asemeComment_676 asemeComment
highlight default link asemeComment_678 asemeComment
highlight default link asemeComment_680 asemeComment
highlight default link asemeComment_682 asemeComment
highlight default link asemeComment_686 asemeComment
highlight default link asemeComment_687 asemeComment
highlight default link asemeComment_69 asemeComment
highlight default link asemeComment_690 asemeComment
highlight default link asemeComment_692 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_697 asemeComment
highlight default link asemeComment_71 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_722 asemeComment
highlight default link asemeComment_724 asemeComment
highlight default link asemeComment_726 asemeComment
highlight default link asemeComment_727 asemeComment
highlight default link asemeComment_73 asemeComment
highlight default link asemeComment_730 asemeComment
highlight default link asemeComment_732 asemeComment
highlight default link asemeComment_75 asemeComment
highlight default link asemeComment_755 asemeComment
highlight default link asemeComment_759 asemeComment
highlight default link asemeComment_762 asemeComment
highlight default link asemeComment_764 asemeComment
highlight default link asemeComment_767 asemeComment
highlight default link asemeComment_771 asemeComment
highlight default link asemeComment_773 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_778 asemeComment
highlight default link asemeComment_780 asemeComment
highlight default link asemeComment_782 asemeComment
highlight default link asemeComment_784 asemeComment
highlight default link asemeComment_787 asemeComment
highlight default link asemeComment_791 asemeComment
highlight default link asemeComment_794 asemeComment
highlight default link asemeComment_796 asemeComment
highlight default link asemeComment_798 asemeComment
highlight default link asemeComment_80 asemeComment
highlight default link asemeComment_801 asemeComment
highlight default link asemeComment_802 asemeComment
highlight default link asemeComment_805 asemeComment
highlight default link asemeComment_807 asemeComment
highlight default link asemeComment_809 asemeComment
highlight default link asemeComment_812 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_839 asemeComment
highlight default link asemeComment_845 asemeComment
highlight default link asemeComment_847 asemeComment
highlight default link asemeComment_849 asemeComment
highlight default link asemeComment_85 asemeComment
highlight default link asemeComment_852 asemeComment
highlight default link asemeComment_854 asemeComment
highlight default link asemeComment_856 asemeComment
highlight default link asemeComment_858 asemeComment
highlight default link asemeComment_862 asemeComment
highlight default link asemeComment_865 asemeComment
highlight default link asemeComment_868 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_878 asemeComment
highlight default link asemeComment_880 asemeComment
highlight default link asemeComment_882 asemeComment
highlight default link asemeComment_885 asemeComment
highlight default link asemeComment_888 asemeComment
highlight default link asemeComment_891 asemeComment
highlight default link asemeComment_894 asemeComment
highlight default link asemeComment_897 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_900 asemeComment
highlight default link asemeComment_903 asemeComment
highlight default link asemeComment_906 asemeComment
highlight default link asemeComment_909 asemeComment
highlight default link asemeComment_91 asemeComment
highlight default link asemeComment_912 asemeComment
highlight default link asemeComment_919 asemeComment
highlight default link asemeComment_921 asemeComment
highlight default link asemeComment_923 asemeComment
highlight default link asemeComment_927 asemeComment
highlight default link asemeComment_929 asemeComment
highlight default link asemeComment_932 asemeComment
highlight default link asemeComment_937 asemeComment
highlight default link asemeComment_941 asemeComment
highlight default link asemeComment_947 asemeComment
highlight default link asemeComment_949 asemeComment
highlight default link asemeComment_951 asemeComment
highlight default link asemeComment_954 asemeComment
highlight default link asemeComment_957 asemeComment
highlight default link asemeComment_96 asemeComment
highlight default link asemeComment_960 asemeComment
highlight default link asemeComment_963 asemeComment
highlight default link asemeComment_966 asemeComment
highlight default link asemeComment_969 asemeComment
highlight default link asemeComment_972 asemeComment
highlight default link asemeComment_975 asemeComment
highlight default link asemeComment_978 asemeComment
highlight default link asemeComment_981 asemeComment
highlight default link asemeComment_987 asemeComment
highlight default link asemeComment_99 asemeComment
highlight default link asemeComment_992 asemeComment
highlight default link asemeComment_995 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_1002 asemeDeclaration
highlight default link asemeDeclaration_1008 asemeDeclaration
highlight default link asemeDeclaration_1027 asemeDeclaration
highlight default link asemeDeclaration_1034 asemeDeclaration
highlight default link asemeDeclaration_1037 asemeDeclaration
highlight default link asemeDeclaration_1061 asemeDeclaration
highlight default link asemeDeclaration_108 asemeDeclaration
highlight default link asemeDeclaration_1104 asemeDeclaration
highlight default link asemeDeclaration_1157 asemeDeclaration
highlight default link asemeDeclaration_1162 asemeDeclaration
highlight default link asemeDeclaration_1164 asemeDeclaration
highlight default link asemeDeclaration_1166 asemeDeclaration
highlight default link asemeDeclaration_1172 asemeDeclaration
highlight default link asemeDeclaration_1241 asemeDeclaration
highlight default link asemeDeclaration_1270 asemeDeclaration
highlight default link asemeDeclaration_1281 asemeDeclaration
highlight default link asemeDeclaration_133 asemeDeclaration
highlight default link asemeDeclaration_138 asemeDeclaration
highlight default link asemeDeclaration_179 asemeDeclaration
highlight default link asemeDeclaration_196 asemeDeclaration
highlight default link asemeDeclaration_202 asemeDeclaration
highlight default link asemeDeclaration_205 asemeDeclaration
highlight default link asemeDeclaration_217 asemeDeclaration
highlight default link asemeDeclaration_235 asemeDeclaration
highlight default link asemeDeclaration_238 asemeDeclaration
highlight default link asemeDeclaration_249 asemeDeclaration
highlight default link asemeDeclaration_343 asemeDeclaration
highlight default link asemeDeclaration_396 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_404 asemeDeclaration
highlight default link asemeDeclaration_457 asemeDeclaration
highlight default link asemeDeclaration_462 asemeDeclaration
highlight default link asemeDeclaration_483 asemeDeclaration
highlight default link asemeDeclaration_497 asemeDeclaration
highlight default link asemeDeclaration_523 asemeDeclaration
highlight default link asemeDeclaration_526 asemeDeclaration
highlight default link asemeDeclaration_559 asemeDeclaration
highlight default link asemeDeclaration_563 asemeDeclaration
highlight default link asemeDeclaration_614 asemeDeclaration
highlight default link asemeDeclaration_667 asemeDeclaration
highlight default link asemeDeclaration_673 asemeDeclaration
highlight default link asemeDeclaration_685 asemeDeclaration
highlight default link asemeDeclaration_70 asemeDeclaration
highlight default link asemeDeclaration_779 asemeDeclaration
highlight default link asemeDeclaration_795 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_82 asemeDeclaration
highlight default link asemeDeclaration_848 asemeDeclaration
highlight default link asemeDeclaration_853 asemeDeclaration
highlight default link asemeDeclaration_877 asemeDeclaration
highlight default link asemeDeclaration_946 asemeDeclaration
highlight default link asemeDeclaration_98 asemeDeclaration
highlight default link asemeDeclaration_999 asemeDeclaration
highlight default link asemeLogic_1084 asemeLogic
highlight default link asemeLogic_1125 asemeLogic
highlight default link asemeLogic_1188 asemeLogic
highlight default link asemeLogic_13 asemeLogic
highlight default link asemeLogic_265 asemeLogic
highlight default link asemeLogic_300 asemeLogic
highlight default link asemeLogic_364 asemeLogic
highlight default link asemeLogic_425 asemeLogic
highlight default link asemeLogic_50 asemeLogic
highlight default link asemeLogic_590 asemeLogic
highlight default link asemeLogic_629 asemeLogic
highlight default link asemeLogic_701 asemeLogic
highlight default link asemeLogic_736 asemeLogic
highlight default link asemeLogic_816 asemeLogic
highlight default link asemeName_100 asemeName
highlight default link asemeName_1043 asemeName
highlight default link asemeName_1047 asemeName
highlight default link asemeName_1053 asemeName
highlight default link asemeName_1055 asemeName
highlight default link asemeName_1147 asemeName
highlight default link asemeName_1155 asemeName
highlight default link asemeName_1160 asemeName
highlight default link asemeName_1206 asemeName
highlight default link asemeName_1226 asemeName
highlight default link asemeName_1228 asemeName
highlight default link asemeName_1236 asemeName
highlight default link asemeName_159 asemeName
highlight default link asemeName_169 asemeName
highlight default link asemeName_174 asemeName
highlight default link asemeName_177 asemeName
highlight default link asemeName_194 asemeName
highlight default link asemeName_195 asemeName
highlight default link asemeName_233 asemeName
highlight default link asemeName_234 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_386 asemeName
highlight default link asemeName_394 asemeName
highlight default link asemeName_402 asemeName
highlight default link asemeName_447 asemeName
highlight default link asemeName_455 asemeName
highlight default link asemeName_460 asemeName
highlight default link asemeName_499 asemeName
highlight default link asemeName_507 asemeName
highlight default link asemeName_519 asemeName
highlight default link asemeName_539 asemeName
highlight default link asemeName_551 asemeName
highlight default link asemeName_558 asemeName
highlight default link asemeName_561 asemeName
highlight default link asemeName_68 asemeName
highlight default link asemeName_77 asemeName
highlight default link asemeName_790 asemeName
highlight default link asemeName_793 asemeName
highlight default link asemeName_838 asemeName
highlight default link asemeName_846 asemeName
highlight default link asemeName_851 asemeName
highlight default link asemeName_855 asemeName
highlight default link asemeName_863 asemeName
highlight default link asemeName_875 asemeName
highlight default link asemeName_89 asemeName
highlight default link asemeName_920 asemeName
highlight default link asemeName_928 asemeName
highlight default link asemeName_93 asemeName
highlight default link asemeName_94 asemeName
highlight default link asemeName_944 asemeName
highlight default link asemeName_997 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1051 asemeNumber
highlight default link asemeNumber_1059 asemeNumber
highlight default link asemeNumber_1064 asemeNumber
highlight default link asemeNumber_1068 asemeNumber
highlight default link asemeNumber_1082 asemeNumber
highlight default link asemeNumber_11 asemeNumber
highlight default link asemeNumber_1102 asemeNumber
highlight default link asemeNumber_1123 asemeNumber
highlight default link asemeNumber_114 asemeNumber
highlight default link asemeNumber_117 asemeNumber
highlight default link asemeNumber_1186 asemeNumber
highlight default link asemeNumber_1212 asemeNumber
highlight default link asemeNumber_1216 asemeNumber
highlight default link asemeNumber_1221 asemeNumber
highlight default link asemeNumber_124 asemeNumber
highlight default link asemeNumber_1244 asemeNumber
highlight default link asemeNumber_1250 asemeNumber
highlight default link asemeNumber_1256 asemeNumber
highlight default link asemeNumber_1262 asemeNumber
highlight default link asemeNumber_1273 asemeNumber
highlight default link asemeNumber_1285 asemeNumber
highlight default link asemeNumber_240 asemeNumber
highlight default link asemeNumber_244 asemeNumber
highlight default link asemeNumber_263 asemeNumber
highlight default link asemeNumber_298 asemeNumber
highlight default link asemeNumber_32 asemeNumber
highlight default link asemeNumber_362 asemeNumber
highlight default link asemeNumber_423 asemeNumber
highlight default link asemeNumber_48 asemeNumber
highlight default link asemeNumber_513 asemeNumber
highlight default link asemeNumber_515 asemeNumber
highlight default link asemeNumber_530 asemeNumber
highlight default link asemeNumber_536 asemeNumber
highlight default link asemeNumber_545 asemeNumber
highlight default link asemeNumber_569 asemeNumber
highlight default link asemeNumber_573 asemeNumber
highlight default link asemeNumber_588 asemeNumber
highlight default link asemeNumber_609 asemeNumber
highlight default link asemeNumber_611 asemeNumber
highlight default link asemeNumber_627 asemeNumber
highlight default link asemeNumber_647 asemeNumber
highlight default link asemeNumber_651 asemeNumber
highlight default link asemeNumber_699 asemeNumber
highlight default link asemeNumber_72 asemeNumber
highlight default link asemeNumber_734 asemeNumber
highlight default link asemeNumber_814 asemeNumber
highlight default link asemeNumber_84 asemeNumber
highlight default link asemeNumber_869 asemeNumber
highlight default link asemeNumber_871 asemeNumber
highlight default link asemeNumber_886 asemeNumber
highlight default link asemeNumber_889 asemeNumber
highlight default link asemeNumber_892 asemeNumber
highlight default link asemeNumber_904 asemeNumber
highlight default link asemeNumber_955 asemeNumber
highlight default link asemeNumber_958 asemeNumber
highlight default link asemeNumber_961 asemeNumber
highlight default link asemeNumber_973 asemeNumber
highlight default link asemeOperator_1010 asemeOperator
highlight default link asemeOperator_1012 asemeOperator
highlight default link asemeOperator_1014 asemeOperator
highlight default link asemeOperator_1015 asemeOperator
highlight default link asemeOperator_1016 asemeOperator
highlight default link asemeOperator_1018 asemeOperator
highlight default link asemeOperator_1021 asemeOperator
highlight default link asemeOperator_1022 asemeOperator
highlight default link asemeOperator_1024 asemeOperator
highlight default link asemeOperator_1066 asemeOperator
highlight default link asemeOperator_1099 asemeOperator
highlight default link asemeOperator_1140 asemeOperator
highlight default link asemeOperator_1142 asemeOperator
highlight default link asemeOperator_1159 asemeOperator
highlight default link asemeOperator_1203 asemeOperator
highlight default link asemeOperator_1205 asemeOperator
highlight default link asemeOperator_1225 asemeOperator
highlight default link asemeOperator_1235 asemeOperator
highlight default link asemeOperator_1246 asemeOperator
highlight default link asemeOperator_1252 asemeOperator
highlight default link asemeOperator_1258 asemeOperator
highlight default link asemeOperator_1264 asemeOperator
highlight default link asemeOperator_1275 asemeOperator
highlight default link asemeOperator_142 asemeOperator
highlight default link asemeOperator_152 asemeOperator
highlight default link asemeOperator_166 asemeOperator
highlight default link asemeOperator_28 asemeOperator
highlight default link asemeOperator_280 asemeOperator
highlight default link asemeOperator_282 asemeOperator
highlight default link asemeOperator_315 asemeOperator
highlight default link asemeOperator_324 asemeOperator
highlight default link asemeOperator_332 asemeOperator
highlight default link asemeOperator_379 asemeOperator
highlight default link asemeOperator_381 asemeOperator
highlight default link asemeOperator_440 asemeOperator
highlight default link asemeOperator_442 asemeOperator
highlight default link asemeOperator_459 asemeOperator
highlight default link asemeOperator_516 asemeOperator
highlight default link asemeOperator_518 asemeOperator
highlight default link asemeOperator_555 asemeOperator
highlight default link asemeOperator_560 asemeOperator
highlight default link asemeOperator_565 asemeOperator
highlight default link asemeOperator_567 asemeOperator
highlight default link asemeOperator_574 asemeOperator
highlight default link asemeOperator_605 asemeOperator
highlight default link asemeOperator_612 asemeOperator
highlight default link asemeOperator_644 asemeOperator
highlight default link asemeOperator_649 asemeOperator
highlight default link asemeOperator_65 asemeOperator
highlight default link asemeOperator_654 asemeOperator
highlight default link asemeOperator_655 asemeOperator
highlight default link asemeOperator_656 asemeOperator
highlight default link asemeOperator_658 asemeOperator
highlight default link asemeOperator_661 asemeOperator
highlight default link asemeOperator_662 asemeOperator
highlight default link asemeOperator_664 asemeOperator
highlight default link asemeOperator_67 asemeOperator
highlight default link asemeOperator_716 asemeOperator
highlight default link asemeOperator_718 asemeOperator
highlight default link asemeOperator_74 asemeOperator
highlight default link asemeOperator_751 asemeOperator
highlight default link asemeOperator_760 asemeOperator
highlight default link asemeOperator_768 asemeOperator
highlight default link asemeOperator_783 asemeOperator
highlight default link asemeOperator_831 asemeOperator
highlight default link asemeOperator_833 asemeOperator
highlight default link asemeOperator_850 asemeOperator
highlight default link asemeOperator_86 asemeOperator
highlight default link asemeOperator_872 asemeOperator
highlight default link asemeOperator_874 asemeOperator
highlight default link asemeOperator_994 asemeOperator
highlight default link asemePunctuation_1004 asemePunctuation
highlight default link asemePunctuation_1029 asemePunctuation
highlight default link asemePunctuation_104 asemePunctuation
highlight default link asemePunctuation_1063 asemePunctuation
highlight default link asemePunctuation_1071 asemePunctuation
highlight default link asemePunctuation_1100 asemePunctuation
highlight default link asemePunctuation_1101 asemePunctuation
highlight default link asemePunctuation_1109 asemePunctuation
highlight default link asemePunctuation_1112 asemePunctuation
highlight default link asemePunctuation_1141 asemePunctuation
highlight default link asemePunctuation_1145 asemePunctuation
highlight default link asemePunctuation_1153 asemePunctuation
highlight default link asemePunctuation_1168 asemePunctuation
highlight default link asemePunctuation_1175 asemePunctuation
highlight default link asemePunctuation_1204 asemePunctuation
highlight default link asemePunctuation_1210 asemePunctuation
highlight default link asemePunctuation_1214 asemePunctuation
highlight default link asemePunctuation_1218 asemePunctuation
highlight default link asemePunctuation_1220 asemePunctuation
highlight default link asemePunctuation_1223 asemePunctuation
highlight default link asemePunctuation_1229 asemePunctuation
highlight default link asemePunctuation_1232 asemePunctuation
highlight default link asemePunctuation_1234 asemePunctuation
highlight default link asemePunctuation_1237 asemePunctuation
highlight default link asemePunctuation_1247 asemePunctuation
highlight default link asemePunctuation_1248 asemePunctuation
highlight default link asemePunctuation_1253 asemePunctuation
highlight default link asemePunctuation_1254 asemePunctuation
highlight default link asemePunctuation_1259 asemePunctuation
highlight default link asemePunctuation_1260 asemePunctuation
highlight default link asemePunctuation_1265 asemePunctuation
highlight default link asemePunctuation_1266 asemePunctuation
highlight default link asemePunctuation_1276 asemePunctuation
highlight default link asemePunctuation_1277 asemePunctuation
highlight default link asemePunctuation_1288 asemePunctuation
highlight default link asemePunctuation_129 asemePunctuation
highlight default link asemePunctuation_135 asemePunctuation
highlight default link asemePunctuation_147 asemePunctuation
highlight default link asemePunctuation_149 asemePunctuation
highlight default link asemePunctuation_157 asemePunctuation
highlight default link asemePunctuation_163 asemePunctuation
highlight default link asemePunctuation_168 asemePunctuation
highlight default link asemePunctuation_173 asemePunctuation
highlight default link asemePunctuation_176 asemePunctuation
highlight default link asemePunctuation_191 asemePunctuation
highlight default link asemePunctuation_198 asemePunctuation
highlight default link asemePunctuation_204 asemePunctuation
highlight default link asemePunctuation_210 asemePunctuation
highlight default link asemePunctuation_213 asemePunctuation
highlight default link asemePunctuation_230 asemePunctuation
highlight default link asemePunctuation_237 asemePunctuation
highlight default link asemePunctuation_242 asemePunctuation
highlight default link asemePunctuation_245 asemePunctuation
highlight default link asemePunctuation_247 asemePunctuation
highlight default link asemePunctuation_252 asemePunctuation
highlight default link asemePunctuation_281 asemePunctuation
highlight default link asemePunctuation_29 asemePunctuation
highlight default link asemePunctuation_292 asemePunctuation
highlight default link asemePunctuation_316 asemePunctuation
highlight default link asemePunctuation_322 asemePunctuation
highlight default link asemePunctuation_327 asemePunctuation
highlight default link asemePunctuation_330 asemePunctuation
highlight default link asemePunctuation_334 asemePunctuation
highlight default link asemePunctuation_339 asemePunctuation
highlight default link asemePunctuation_348 asemePunctuation
highlight default link asemePunctuation_35 asemePunctuation
highlight default link asemePunctuation_351 asemePunctuation
highlight default link asemePunctuation_37 asemePunctuation
highlight default link asemePunctuation_380 asemePunctuation
highlight default link asemePunctuation_384 asemePunctuation
highlight default link asemePunctuation_392 asemePunctuation
highlight default link asemePunctuation_400 asemePunctuation
highlight default link asemePunctuation_409 asemePunctuation
highlight default link asemePunctuation_412 asemePunctuation
highlight default link asemePunctuation_441 asemePunctuation
highlight default link asemePunctuation_445 asemePunctuation
highlight default link asemePunctuation_453 asemePunctuation
highlight default link asemePunctuation_475 asemePunctuation
highlight default link asemePunctuation_489 asemePunctuation
highlight default link asemePunctuation_501 asemePunctuation
highlight default link asemePunctuation_505 asemePunctuation
highlight default link asemePunctuation_508 asemePunctuation
highlight default link asemePunctuation_510 asemePunctuation
highlight default link asemePunctuation_517 asemePunctuation
highlight default link asemePunctuation_520 asemePunctuation
highlight default link asemePunctuation_552 asemePunctuation
highlight default link asemePunctuation_557 asemePunctuation
highlight default link asemePunctuation_577 asemePunctuation
highlight default link asemePunctuation_606 asemePunctuation
highlight default link asemePunctuation_607 asemePunctuation
highlight default link asemePunctuation_613 asemePunctuation
highlight default link asemePunctuation_616 asemePunctuation
highlight default link asemePunctuation_645 asemePunctuation
highlight default link asemePunctuation_646 asemePunctuation
highlight default link asemePunctuation_653 asemePunctuation
highlight default link asemePunctuation_66 asemePunctuation
highlight default link asemePunctuation_669 asemePunctuation
highlight default link asemePunctuation_681 asemePunctuation
highlight default link asemePunctuation_688 asemePunctuation
highlight default link asemePunctuation_717 asemePunctuation
highlight default link asemePunctuation_728 asemePunctuation
highlight default link asemePunctuation_752 asemePunctuation
highlight default link asemePunctuation_758 asemePunctuation
highlight default link asemePunctuation_76 asemePunctuation
highlight default link asemePunctuation_763 asemePunctuation
highlight default link asemePunctuation_766 asemePunctuation
highlight default link asemePunctuation_770 asemePunctuation
highlight default link asemePunctuation_775 asemePunctuation
highlight default link asemePunctuation_78 asemePunctuation
highlight default link asemePunctuation_786 asemePunctuation
highlight default link asemePunctuation_800 asemePunctuation
highlight default link asemePunctuation_803 asemePunctuation
highlight default link asemePunctuation_832 asemePunctuation
highlight default link asemePunctuation_836 asemePunctuation
highlight default link asemePunctuation_844 asemePunctuation
highlight default link asemePunctuation_857 asemePunctuation
highlight default link asemePunctuation_861 asemePunctuation
highlight default link asemePunctuation_864 asemePunctuation
highlight default link asemePunctuation_866 asemePunctuation
highlight default link asemePunctuation_873 asemePunctuation
highlight default link asemePunctuation_876 asemePunctuation
highlight default link asemePunctuation_88 asemePunctuation
highlight default link asemePunctuation_918 asemePunctuation
highlight default link asemePunctuation_922 asemePunctuation
highlight default link asemePunctuation_926 asemePunctuation
highlight default link asemePunctuation_936 asemePunctuation
highlight default link asemePunctuation_940 asemePunctuation
highlight default link asemePunctuation_942 asemePunctuation
highlight default link asemePunctuation_945 asemePunctuation
highlight default link asemePunctuation_991 asemePunctuation
highlight default link asemePunctuation_998 asemePunctuation
highlight default link asemeReference_1039 asemeReference
highlight default link asemeReference_1072 asemeReference
highlight default link asemeReference_1074 asemeReference
highlight default link asemeReference_1078 asemeReference
highlight default link asemeReference_1098 asemeReference
highlight default link asemeReference_110 asemeReference
highlight default link asemeReference_1113 asemeReference
highlight default link asemeReference_1115 asemeReference
highlight default link asemeReference_1119 asemeReference
highlight default link asemeReference_1139 asemeReference
highlight default link asemeReference_1176 asemeReference
highlight default link asemeReference_1178 asemeReference
highlight default link asemeReference_1182 asemeReference
highlight default link asemeReference_120 asemeReference
highlight default link asemeReference_1202 asemeReference
highlight default link asemeReference_1231 asemeReference
highlight default link asemeReference_1245 asemeReference
highlight default link asemeReference_1251 asemeReference
highlight default link asemeReference_1257 asemeReference
highlight default link asemeReference_1263 asemeReference
highlight default link asemeReference_1274 asemeReference
highlight default link asemeReference_128 asemeReference
highlight default link asemeReference_1286 asemeReference
highlight default link asemeReference_1287 asemeReference
highlight default link asemeReference_131 asemeReference
highlight default link asemeReference_132 asemeReference
highlight default link asemeReference_181 asemeReference
highlight default link asemeReference_187 asemeReference
highlight default link asemeReference_190 asemeReference
highlight default link asemeReference_209 asemeReference
highlight default link asemeReference_215 asemeReference
highlight default link asemeReference_216 asemeReference
highlight default link asemeReference_219 asemeReference
highlight default link asemeReference_223 asemeReference
highlight default link asemeReference_226 asemeReference
highlight default link asemeReference_229 asemeReference
highlight default link asemeReference_253 asemeReference
highlight default link asemeReference_255 asemeReference
highlight default link asemeReference_259 asemeReference
highlight default link asemeReference_27 asemeReference
highlight default link asemeReference_279 asemeReference
highlight default link asemeReference_283 asemeReference
highlight default link asemeReference_287 asemeReference
highlight default link asemeReference_293 asemeReference
highlight default link asemeReference_295 asemeReference
highlight default link asemeReference_314 asemeReference
highlight default link asemeReference_321 asemeReference
highlight default link asemeReference_325 asemeReference
highlight default link asemeReference_329 asemeReference
highlight default link asemeReference_33 asemeReference
highlight default link asemeReference_333 asemeReference
highlight default link asemeReference_336 asemeReference
highlight default link asemeReference_338 asemeReference
highlight default link asemeReference_34 asemeReference
highlight default link asemeReference_341 asemeReference
highlight default link asemeReference_352 asemeReference
highlight default link asemeReference_354 asemeReference
highlight default link asemeReference_358 asemeReference
highlight default link asemeReference_378 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_40 asemeReference
highlight default link asemeReference_413 asemeReference
highlight default link asemeReference_415 asemeReference
highlight default link asemeReference_419 asemeReference
highlight default link asemeReference_439 asemeReference
highlight default link asemeReference_44 asemeReference
highlight default link asemeReference_464 asemeReference
highlight default link asemeReference_468 asemeReference
highlight default link asemeReference_472 asemeReference
highlight default link asemeReference_473 asemeReference
highlight default link asemeReference_477 asemeReference
highlight default link asemeReference_478 asemeReference
highlight default link asemeReference_480 asemeReference
highlight default link asemeReference_481 asemeReference
highlight default link asemeReference_485 asemeReference
highlight default link asemeReference_487 asemeReference
highlight default link asemeReference_491 asemeReference
highlight default link asemeReference_492 asemeReference
highlight default link asemeReference_494 asemeReference
highlight default link asemeReference_495 asemeReference
highlight default link asemeReference_514 asemeReference
highlight default link asemeReference_554 asemeReference
highlight default link asemeReference_578 asemeReference
highlight default link asemeReference_580 asemeReference
highlight default link asemeReference_584 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_604 asemeReference
highlight default link asemeReference_610 asemeReference
highlight default link asemeReference_617 asemeReference
highlight default link asemeReference_619 asemeReference
highlight default link asemeReference_623 asemeReference
highlight default link asemeReference_64 asemeReference
highlight default link asemeReference_643 asemeReference
highlight default link asemeReference_679 asemeReference
highlight default link asemeReference_683 asemeReference
highlight default link asemeReference_684 asemeReference
highlight default link asemeReference_689 asemeReference
highlight default link asemeReference_691 asemeReference
highlight default link asemeReference_695 asemeReference
highlight default link asemeReference_715 asemeReference
highlight default link asemeReference_719 asemeReference
highlight default link asemeReference_723 asemeReference
highlight default link asemeReference_729 asemeReference
highlight default link asemeReference_731 asemeReference
highlight default link asemeReference_750 asemeReference
highlight default link asemeReference_757 asemeReference
highlight default link asemeReference_761 asemeReference
highlight default link asemeReference_765 asemeReference
highlight default link asemeReference_769 asemeReference
highlight default link asemeReference_772 asemeReference
highlight default link asemeReference_774 asemeReference
highlight default link asemeReference_777 asemeReference
highlight default link asemeReference_781 asemeReference
highlight default link asemeReference_785 asemeReference
highlight default link asemeReference_804 asemeReference
highlight default link asemeReference_806 asemeReference
highlight default link asemeReference_810 asemeReference
highlight default link asemeReference_830 asemeReference
highlight default link asemeReference_870 asemeReference
highlight default link asemeReference_879 asemeReference
highlight default link asemeReference_883 asemeReference
highlight default link asemeReference_898 asemeReference
highlight default link asemeReference_901 asemeReference
highlight default link asemeReference_907 asemeReference
highlight default link asemeReference_910 asemeReference
highlight default link asemeReference_930 asemeReference
highlight default link asemeReference_933 asemeReference
highlight default link asemeReference_934 asemeReference
highlight default link asemeReference_935 asemeReference
highlight default link asemeReference_943 asemeReference
highlight default link asemeReference_948 asemeReference
highlight default link asemeReference_952 asemeReference
highlight default link asemeReference_967 asemeReference
highlight default link asemeReference_970 asemeReference
highlight default link asemeReference_976 asemeReference
highlight default link asemeReference_979 asemeReference
highlight default link asemeReference_985 asemeReference
highlight default link asemeReference_988 asemeReference
highlight default link asemeReference_989 asemeReference
highlight default link asemeReference_990 asemeReference
highlight default link asemeReference_996 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1001 asemeText
highlight default link asemeText_1044 asemeText
highlight default link asemeText_1048 asemeText
highlight default link asemeText_1054 asemeText
highlight default link asemeText_1056 asemeText
highlight default link asemeText_1081 asemeText
highlight default link asemeText_1122 asemeText
highlight default link asemeText_1185 asemeText
highlight default link asemeText_1243 asemeText
highlight default link asemeText_1249 asemeText
highlight default link asemeText_1255 asemeText
highlight default link asemeText_1261 asemeText
highlight default link asemeText_1267 asemeText
highlight default link asemeText_1269 asemeText
highlight default link asemeText_1272 asemeText
highlight default link asemeText_1278 asemeText
highlight default link asemeText_1280 asemeText
highlight default link asemeText_1283 asemeText
highlight default link asemeText_1284 asemeText
highlight default link asemeText_140 asemeText
highlight default link asemeText_151 asemeText
highlight default link asemeText_165 asemeText
highlight default link asemeText_193 asemeText
highlight default link asemeText_232 asemeText
highlight default link asemeText_248 asemeText
highlight default link asemeText_262 asemeText
highlight default link asemeText_297 asemeText
highlight default link asemeText_30 asemeText
highlight default link asemeText_31 asemeText
highlight default link asemeText_361 asemeText
highlight default link asemeText_422 asemeText
highlight default link asemeText_47 asemeText
highlight default link asemeText_511 asemeText
highlight default link asemeText_525 asemeText
highlight default link asemeText_587 asemeText
highlight default link asemeText_608 asemeText
highlight default link asemeText_626 asemeText
highlight default link asemeText_698 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_733 asemeText
highlight default link asemeText_788 asemeText
highlight default link asemeText_789 asemeText
highlight default link asemeText_792 asemeText
highlight default link asemeText_813 asemeText
highlight default link asemeText_867 asemeText
highlight default link asemeText_993 asemeText
highlight default link asemeTruth_1083 asemeTruth
highlight default link asemeTruth_1124 asemeTruth
highlight default link asemeTruth_1187 asemeTruth
highlight default link asemeTruth_12 asemeTruth
highlight default link asemeTruth_264 asemeTruth
highlight default link asemeTruth_299 asemeTruth
highlight default link asemeTruth_363 asemeTruth
highlight default link asemeTruth_424 asemeTruth
highlight default link asemeTruth_49 asemeTruth
highlight default link asemeTruth_589 asemeTruth
highlight default link asemeTruth_628 asemeTruth
highlight default link asemeTruth_700 asemeTruth
highlight default link asemeTruth_735 asemeTruth
highlight default link asemeTruth_815 asemeTruth
highlight default link asemeType_103 asemeType
highlight default link asemeType_1108 asemeType
highlight default link asemeType_1144 asemeType
highlight default link asemeType_1150 asemeType
highlight default link asemeType_1152 asemeType
highlight default link asemeType_146 asemeType
highlight default link asemeType_156 asemeType
highlight default link asemeType_162 asemeType
highlight default link asemeType_172 asemeType
highlight default link asemeType_347 asemeType
highlight default link asemeType_383 asemeType
highlight default link asemeType_389 asemeType
highlight default link asemeType_391 asemeType
highlight default link asemeType_399 asemeType
highlight default link asemeType_408 asemeType
highlight default link asemeType_444 asemeType
highlight default link asemeType_450 asemeType
highlight default link asemeType_452 asemeType
highlight default link asemeType_504 asemeType
highlight default link asemeType_799 asemeType
highlight default link asemeType_835 asemeType
highlight default link asemeType_841 asemeType
highlight default link asemeType_843 asemeType
highlight default link asemeType_860 asemeType
highlight default link asemeType_917 asemeType
highlight default link asemeType_92 asemeType
highlight default link asemeType_925 asemeType
highlight default link asemeType_939 asemeType
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
