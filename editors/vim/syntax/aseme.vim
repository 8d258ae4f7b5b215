" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
" A declaration that begins a line stands in nothing else: what is before it need not be read.
syntax sync match asemeDeclarationHere grouphere NONE /\v^%(language|system|import|let|enum|message|topic|function|sag|suc|aip|abstract|srm|statechart|team|scenario|property)>/
syntax match asemeReference_1227 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_1226 /\v\w+/
syntax match asemeNumber_1225 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_1224 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_1223 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_1228 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_1223,asemeText_1224,asemeNumber_1225,asemeReference_1226,asemeReference_1227,asemePunctuation_1228,asemeComment
syntax match asemeReference_34 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_33 /\v\w+/ contained
syntax match asemeNumber_32 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_31 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_30 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_35 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_70,asemeDeclaration_82,asemeDeclaration_108,asemeDeclaration_138,asemeDeclaration_179,asemeDeclaration_205,asemeDeclaration_238,asemeDeclaration_643,asemeDeclaration_974,asemeDeclaration_977,asemeDeclaration_1112,asemeDeclaration_1181,asemeDeclaration_1210,asemeDeclaration_1221,asemeText_1223,asemeText_1224,asemeNumber_1225,asemeReference_1226,asemeReference_1227,asemePunctuation_1228,asemeComment
syntax match asemeDeclaration_1221 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_1220,asemeComment_1222 skipwhite skipempty
syntax region asemeComment_1222 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1220,asemeComment_1222 skipwhite skipempty
syntax match asemeComment_1222 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1220,asemeComment_1222 skipwhite skipempty
syntax match asemeText_1220 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1219 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_1217,asemeText_1218
syntax match asemeText_1218 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1219 skipwhite skipempty
syntax region asemeComment_1219 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1219 skipwhite skipempty
syntax match asemeComment_1219 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_1219 skipwhite skipempty
syntax region asemePunctuation_1217 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_1200,asemeText_1212,asemeNumber_1213,asemeReference_1214,asemeOperator_1215,asemePunctuation_1216,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1216 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1215 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1214 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1213 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1212 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1210 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_1209,asemeComment_1211 skipwhite skipempty
syntax region asemeComment_1211 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_1209,asemeComment_1211 skipwhite skipempty
syntax match asemeComment_1211 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_1209,asemeComment_1211 skipwhite skipempty
syntax match asemeText_1209 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1208 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_1206,asemeText_1207
syntax match asemeText_1207 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1208 skipwhite skipempty
syntax region asemeComment_1208 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1208 skipwhite skipempty
syntax match asemeComment_1208 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_1208 skipwhite skipempty
syntax region asemePunctuation_1206 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_1200,asemeText_1201,asemeNumber_1202,asemeReference_1203,asemeOperator_1204,asemePunctuation_1205,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1205 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1204 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1203 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1202 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1201 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1200 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_1194,asemeText_1195,asemeNumber_1196,asemeReference_1197,asemeOperator_1198,asemePunctuation_1199,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1199 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1198 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1197 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1196 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1195 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1194 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_1188,asemeText_1189,asemeNumber_1190,asemeReference_1191,asemeOperator_1192,asemePunctuation_1193,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1193 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1192 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1191 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1190 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1189 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_1188 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_1183,asemeNumber_1184,asemeReference_1185,asemeOperator_1186,asemePunctuation_1187,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemePunctuation_1187 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_1186 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_1185 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_1184 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_1183 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_1181 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_1180,asemeComment_1182 skipwhite skipempty
syntax region asemeComment_1182 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1180,asemeComment_1182 skipwhite skipempty
syntax match asemeComment_1182 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1180,asemeComment_1182 skipwhite skipempty
syntax match asemeBlock_1180 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1179 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_1177,asemeBlock_1178
syntax match asemeBlock_1178 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_1179 skipwhite skipempty
syntax region asemeComment_1179 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1179 skipwhite skipempty
syntax match asemeComment_1179 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_1179 skipwhite skipempty
syntax region asemePunctuation_1177 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_1176,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_1176 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_1148,asemePunctuation_1158,asemePunctuation_1163,asemePunctuation_1169,asemePunctuation_1172,asemePunctuation_1174,asemeOperator_1175
syntax match asemeOperator_1175 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemePunctuation_1174 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax match asemePunctuation_1172 /\v\:/ contained nextgroup=asemeReference_1171,asemeComment_1173 skipwhite skipempty
syntax region asemeComment_1173 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1171,asemeComment_1173 skipwhite skipempty
syntax match asemeComment_1173 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1171,asemeComment_1173 skipwhite skipempty
syntax match asemeReference_1171 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax match asemePunctuation_1169 /\v\,/ contained nextgroup=asemeName_1166,asemeName_1168,asemeComment_1170 skipwhite skipempty
syntax region asemeComment_1170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1166,asemeName_1168,asemeComment_1170 skipwhite skipempty
syntax match asemeComment_1170 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1166,asemeName_1168,asemeComment_1170 skipwhite skipempty
syntax match asemeName_1168 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax match asemeName_1166 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1165,asemeComment_1167 skipwhite skipempty
syntax region asemeComment_1167 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1165,asemeComment_1167 skipwhite skipempty
syntax match asemeComment_1167 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1165,asemeComment_1167 skipwhite skipempty
syntax match asemeOperator_1165 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemePunctuation_1163 /\v\.\./ contained nextgroup=asemeNumber_1161,asemeComment_1164 skipwhite skipempty
syntax region asemeComment_1164 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1161,asemeComment_1164 skipwhite skipempty
syntax match asemeComment_1164 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1161,asemeComment_1164 skipwhite skipempty
syntax match asemeNumber_1161 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1160,asemeComment_1162 skipwhite skipempty
syntax region asemeComment_1162 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1160,asemeComment_1162 skipwhite skipempty
syntax match asemeComment_1162 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1160,asemeComment_1162 skipwhite skipempty
syntax match asemePunctuation_1160 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax match asemePunctuation_1158 /\v\[/ contained nextgroup=asemeNumber_1156,asemeComment_1159 skipwhite skipempty
syntax region asemeComment_1159 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1156,asemeComment_1159 skipwhite skipempty
syntax match asemeComment_1159 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1156,asemeComment_1159 skipwhite skipempty
syntax match asemeNumber_1156 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1154,asemeComment_1157 skipwhite skipempty
syntax region asemeComment_1157 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1154,asemeComment_1157 skipwhite skipempty
syntax match asemeComment_1157 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1154,asemeComment_1157 skipwhite skipempty
syntax match asemePunctuation_1154 /\v\.\./ contained nextgroup=asemeNumber_1152,asemeComment_1155 skipwhite skipempty
syntax region asemeComment_1155 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1152,asemeComment_1155 skipwhite skipempty
syntax match asemeComment_1155 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1152,asemeComment_1155 skipwhite skipempty
syntax match asemeNumber_1152 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_1150,asemeComment_1153 skipwhite skipempty
syntax region asemeComment_1153 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1150,asemeComment_1153 skipwhite skipempty
syntax match asemeComment_1153 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1150,asemeComment_1153 skipwhite skipempty
syntax match asemePunctuation_1150 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax region asemeComment_1151 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax match asemeComment_1151 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_1151 skipwhite skipempty
syntax match asemeClause_1148 /\vwith%(<|>)/ contained nextgroup=asemeName_1146,asemeComment_1149 skipwhite skipempty
syntax region asemeComment_1149 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1146,asemeComment_1149 skipwhite skipempty
syntax match asemeComment_1149 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1146,asemeComment_1149 skipwhite skipempty
syntax match asemeName_1146 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1145,asemeComment_1147 skipwhite skipempty
syntax region asemeComment_1147 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1145,asemeComment_1147 skipwhite skipempty
syntax match asemeComment_1147 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1145,asemeComment_1147 skipwhite skipempty
syntax match asemeOperator_1145 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeDeclaration_1112 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_1111,asemeComment_1113 skipwhite skipempty
syntax region asemeComment_1113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_1111,asemeComment_1113 skipwhite skipempty
syntax match asemeComment_1113 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_1111,asemeComment_1113 skipwhite skipempty
syntax match asemeBlock_1111 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1110 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_1108,asemeBlock_1109
syntax match asemeBlock_1109 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_1110 skipwhite skipempty
syntax region asemeComment_1110 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1110 skipwhite skipempty
syntax match asemeComment_1110 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_1110 skipwhite skipempty
syntax region asemePunctuation_1108 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_1001,asemeNumber_1008,asemeDeclaration_1044,asemeDeclaration_1097,asemeDeclaration_1102,asemeDeclaration_1104,asemeDeclaration_1106,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_1106 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax region asemeComment_1107 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax match asemeComment_1107 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_1107 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_938
syntax match asemeDeclaration_1104 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1105 skipwhite skipempty
syntax region asemeComment_1105 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1105 skipwhite skipempty
syntax match asemeComment_1105 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_1105 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_885
syntax match asemeDeclaration_1102 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_1100,asemeComment_1103 skipwhite skipempty
syntax region asemeComment_1103 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1100,asemeComment_1103 skipwhite skipempty
syntax match asemeComment_1103 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1100,asemeComment_1103 skipwhite skipempty
syntax match asemeName_1100 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_1099,asemeComment_1101 skipwhite skipempty
syntax region asemeComment_1101 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1099,asemeComment_1101 skipwhite skipempty
syntax match asemeComment_1101 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1099,asemeComment_1101 skipwhite skipempty
syntax match asemeOperator_1099 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_1097 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_1095,asemeComment_1098 skipwhite skipempty
syntax region asemeComment_1098 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_1095,asemeComment_1098 skipwhite skipempty
syntax match asemeComment_1098 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_1095,asemeComment_1098 skipwhite skipempty
syntax match asemeName_1095 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_1093,asemeComment_1096 skipwhite skipempty
syntax region asemeComment_1096 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1093,asemeComment_1096 skipwhite skipempty
syntax match asemeComment_1096 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1093,asemeComment_1096 skipwhite skipempty
syntax match asemePunctuation_1093 /\v\:/ contained nextgroup=asemeBuiltIn_1091,asemeType_1092,asemeComment_1094 skipwhite skipempty
syntax region asemeComment_1094 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1091,asemeType_1092,asemeComment_1094 skipwhite skipempty
syntax match asemeComment_1094 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1091,asemeType_1092,asemeComment_1094 skipwhite skipempty
syntax match asemeType_1092 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeBuiltIn_1091 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_1049,asemeOperator_1082,asemeName_1087,asemeBuiltIn_1089,asemeType_1090
syntax match asemeType_1090 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeBuiltIn_1089 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeName_1087 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_1085,asemeComment_1088 skipwhite skipempty
syntax region asemeComment_1088 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1085,asemeComment_1088 skipwhite skipempty
syntax match asemeComment_1088 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1085,asemeComment_1088 skipwhite skipempty
syntax match asemePunctuation_1085 /\v\:/ contained nextgroup=asemeBuiltIn_1083,asemeType_1084,asemeComment_1086 skipwhite skipempty
syntax region asemeComment_1086 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1083,asemeType_1084,asemeComment_1086 skipwhite skipempty
syntax match asemeComment_1086 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1083,asemeType_1084,asemeComment_1086 skipwhite skipempty
syntax match asemeType_1084 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeBuiltIn_1083 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeOperator_1082 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemePunctuation_1049 /\v\:/ contained nextgroup=asemeBuiltIn_1046,asemeType_1048,asemeComment_1050 skipwhite skipempty
syntax region asemeComment_1050 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_1046,asemeType_1048,asemeComment_1050 skipwhite skipempty
syntax match asemeComment_1050 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_1046,asemeType_1048,asemeComment_1050 skipwhite skipempty
syntax match asemeType_1048 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeBuiltIn_1046 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax region asemeComment_1047 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeComment_1047 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_1047 skipwhite skipempty
syntax match asemeDeclaration_1044 /\v%(%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=%(on|exit)%(<|>)/ contained nextgroup=asemeNumber_1042,asemeComment_1045 skipwhite skipempty
syntax region asemeComment_1045 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1042,asemeComment_1045 skipwhite skipempty
syntax match asemeComment_1045 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1042,asemeComment_1045 skipwhite skipempty
syntax match asemeNumber_1042 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1041,asemeComment_1043 skipwhite skipempty
syntax region asemeComment_1043 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1041,asemeComment_1043 skipwhite skipempty
syntax match asemeComment_1043 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1041,asemeComment_1043 skipwhite skipempty
syntax match asemePunctuation_1041 /\v\:/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeNumber_1008 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_1006,asemeComment_1009 skipwhite skipempty
syntax region asemeComment_1009 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_1006,asemeComment_1009 skipwhite skipempty
syntax match asemeComment_1009 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_1006,asemeComment_1009 skipwhite skipempty
syntax match asemeOperator_1006 /\v\-\>/ contained nextgroup=asemeNumber_1004,asemeComment_1007 skipwhite skipempty
syntax region asemeComment_1007 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_1004,asemeComment_1007 skipwhite skipempty
syntax match asemeComment_1007 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_1004,asemeComment_1007 skipwhite skipempty
syntax match asemeNumber_1004 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_1003,asemeComment_1005 skipwhite skipempty
syntax region asemeComment_1005 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1003,asemeComment_1005 skipwhite skipempty
syntax match asemeComment_1005 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1003,asemeComment_1005 skipwhite skipempty
syntax match asemePunctuation_1003 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeDeclaration_1001 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_999,asemeComment_1002 skipwhite skipempty
syntax region asemeComment_1002 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_999,asemeComment_1002 skipwhite skipempty
syntax match asemeComment_1002 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_999,asemeComment_1002 skipwhite skipempty
syntax match asemeNumber_999 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_997,asemeComment_1000 skipwhite skipempty
syntax region asemeComment_1000 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_997,asemeComment_1000 skipwhite skipempty
syntax match asemeComment_1000 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_997,asemeComment_1000 skipwhite skipempty
syntax match asemeChoice_997 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_995,asemeText_996,@asemeChartNodeInBodyOfStatechart,asemeComment_998 skipwhite skipempty
syntax region asemeComment_998 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_995,asemeText_996,@asemeChartNodeInBodyOfStatechart,asemeComment_998 skipwhite skipempty
syntax match asemeComment_998 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_995,asemeText_996,@asemeChartNodeInBodyOfStatechart,asemeComment_998 skipwhite skipempty
syntax match asemeText_996 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeName_995 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_981,asemeChoice_985,asemeNumber_991,asemeName_993,asemeText_994
syntax match asemeText_994 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeName_993 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|%(on|exit)%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeNumber_991 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_989,asemeComment_992 skipwhite skipempty
syntax region asemeComment_992 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_989,asemeComment_992 skipwhite skipempty
syntax match asemeComment_992 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_989,asemeComment_992 skipwhite skipempty
syntax match asemeChoice_989 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_987,asemeText_988,@asemeChartNodeInBodyOfStatechart,asemeComment_990 skipwhite skipempty
syntax region asemeComment_990 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_987,asemeText_988,@asemeChartNodeInBodyOfStatechart,asemeComment_990 skipwhite skipempty
syntax match asemeComment_990 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_987,asemeText_988,@asemeChartNodeInBodyOfStatechart,asemeComment_990 skipwhite skipempty
syntax match asemeText_988 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeName_987 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeChoice_985 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_983,asemeText_984,@asemeChartNodeInBodyOfStatechart,asemeComment_986 skipwhite skipempty
syntax region asemeComment_986 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_983,asemeText_984,@asemeChartNodeInBodyOfStatechart,asemeComment_986 skipwhite skipempty
syntax match asemeComment_986 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_983,asemeText_984,@asemeChartNodeInBodyOfStatechart,asemeComment_986 skipwhite skipempty
syntax match asemeText_984 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeName_983 /\v%(%(%(state|activity|activities|modules|var|let)%(<|>)|%(on|exit)\_s+[0-9]))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeClause_981 /\vactivity%(<|>)/ contained nextgroup=asemeReference_979,asemeComment_982 skipwhite skipempty
syntax region asemeComment_982 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_979,asemeComment_982 skipwhite skipempty
syntax match asemeComment_982 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_979,asemeComment_982 skipwhite skipempty
syntax match asemeReference_979 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax region asemeComment_980 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeComment_980 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_980 skipwhite skipempty
syntax match asemeDeclaration_977 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_976,asemeComment_978 skipwhite skipempty
syntax region asemeComment_978 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_976,asemeComment_978 skipwhite skipempty
syntax match asemeComment_978 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_976,asemeComment_978 skipwhite skipempty
syntax match asemeBlock_976 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_646 skipwhite skipempty
syntax match asemeDeclaration_974 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_972,asemeComment_975 skipwhite skipempty
syntax region asemeComment_975 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_972,asemeComment_975 skipwhite skipempty
syntax match asemeComment_975 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_972,asemeComment_975 skipwhite skipempty
syntax match asemeClause_972 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_971,asemeComment_973 skipwhite skipempty
syntax region asemeComment_973 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_971,asemeComment_973 skipwhite skipempty
syntax match asemeComment_973 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_971,asemeComment_973 skipwhite skipempty
syntax match asemeBlock_971 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_646 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_647,asemePunctuation_969,asemeBlock_970
syntax match asemeBlock_970 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_646 skipwhite skipempty
syntax region asemePunctuation_969 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_655,asemeDeclaration_719,asemeDeclaration_735,asemeDeclaration_788,asemeDeclaration_793,asemeDeclaration_817,asemeDeclaration_886,asemeDeclaration_939,asemeDeclaration_948,asemeDeclaration_967,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_967 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_965,asemeComment_968 skipwhite skipempty
syntax region asemeComment_968 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_965,asemeComment_968 skipwhite skipempty
syntax match asemeComment_968 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_965,asemeComment_968 skipwhite skipempty
syntax match asemeBlock_965 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_962,asemeOperator_964,@asemeControlInBodyOfSrm,asemeComment_966 skipwhite skipempty
syntax region asemeComment_966 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_962,asemeOperator_964,@asemeControlInBodyOfSrm,asemeComment_966 skipwhite skipempty
syntax match asemeComment_966 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_962,asemeOperator_964,@asemeControlInBodyOfSrm,asemeComment_966 skipwhite skipempty
syntax match asemeOperator_964 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax match asemeOperator_962 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_961,@asemeControlInBodyOfSrm,asemeComment_963 skipwhite skipempty
syntax region asemeComment_963 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_961,@asemeControlInBodyOfSrm,asemeComment_963 skipwhite skipempty
syntax match asemeComment_963 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_961,@asemeControlInBodyOfSrm,asemeComment_963 skipwhite skipempty
syntax match asemeOperator_961 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemeOperator_952,asemePunctuation_623,asemeOperator_954,asemeBlock_959
syntax match asemeBlock_959 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_956,asemeOperator_958,@asemeControlInBodyOfSrm,asemeComment_960 skipwhite skipempty
syntax region asemeComment_960 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_956,asemeOperator_958,@asemeControlInBodyOfSrm,asemeComment_960 skipwhite skipempty
syntax match asemeComment_960 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_956,asemeOperator_958,@asemeControlInBodyOfSrm,asemeComment_960 skipwhite skipempty
syntax match asemeOperator_958 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax match asemeOperator_956 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_955,@asemeControlInBodyOfSrm,asemeComment_957 skipwhite skipempty
syntax region asemeComment_957 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_955,@asemeControlInBodyOfSrm,asemeComment_957 skipwhite skipempty
syntax match asemeComment_957 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_955,@asemeControlInBodyOfSrm,asemeComment_957 skipwhite skipempty
syntax match asemeOperator_955 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax match asemeOperator_954 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax match asemeOperator_952 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_950,@asemeControlInBodyOfSrm,asemeComment_953 skipwhite skipempty
syntax region asemeComment_953 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_950,@asemeControlInBodyOfSrm,asemeComment_953 skipwhite skipempty
syntax match asemeComment_953 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_950,@asemeControlInBodyOfSrm,asemeComment_953 skipwhite skipempty
syntax match asemeOperator_950 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax region asemeComment_951 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax match asemeComment_951 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_951 skipwhite skipempty
syntax match asemeDeclaration_948 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_947,asemeComment_949 skipwhite skipempty
syntax region asemeComment_949 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_947,asemeComment_949 skipwhite skipempty
syntax match asemeComment_949 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_947,asemeComment_949 skipwhite skipempty
syntax match asemeBlock_947 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_946 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_944,asemeBlock_945
syntax match asemeBlock_945 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_946 skipwhite skipempty
syntax region asemeComment_946 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_946 skipwhite skipempty
syntax match asemeComment_946 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_946 skipwhite skipempty
syntax region asemePunctuation_944 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_942,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_942 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_941,asemeComment_943 skipwhite skipempty
syntax region asemeComment_943 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_941,asemeComment_943 skipwhite skipempty
syntax match asemeComment_943 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_941,asemeComment_943 skipwhite skipempty
syntax match asemeText_941 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_939 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_940 skipwhite skipempty
syntax region asemeComment_940 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_940 skipwhite skipempty
syntax match asemeComment_940 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_940 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_938
syntax region asemePunctuation_938 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_937,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_937 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_893,asemeClause_896,asemeClause_899,asemeClause_902,asemeClause_905,asemeClause_908,asemeChoice_911,asemeClause_914,asemeClause_917,asemeClause_920,asemeClause_922,asemeChoice_923,asemeChoice_924,asemePunctuation_931,asemeOperator_934,asemeReference_936
syntax match asemeReference_936 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeOperator_934 /\v\=%(\=)@!/ contained nextgroup=asemeText_933,asemeComment_935 skipwhite skipempty
syntax region asemeComment_935 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_933,asemeComment_935 skipwhite skipempty
syntax match asemeComment_935 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_933,asemeComment_935 skipwhite skipempty
syntax match asemeText_933 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemePunctuation_931 /\v\,/ contained nextgroup=asemeChoice_926,asemeReference_928,asemeReference_929,asemeReference_930,asemeComment_932 skipwhite skipempty
syntax region asemeComment_932 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_926,asemeReference_928,asemeReference_929,asemeReference_930,asemeComment_932 skipwhite skipempty
syntax match asemeComment_932 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_926,asemeReference_928,asemeReference_929,asemeReference_930,asemeComment_932 skipwhite skipempty
syntax match asemeReference_930 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeReference_929 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeReference_928 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeChoice_926 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_925,asemeComment_927 skipwhite skipempty
syntax region asemeComment_927 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_925,asemeComment_927 skipwhite skipempty
syntax match asemeComment_927 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_925,asemeComment_927 skipwhite skipempty
syntax match asemeReference_925 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeChoice_924 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeChoice_923 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_922 /\vsimulated%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_920 /\vends%(<|>)/ contained nextgroup=asemeReference_919,asemeComment_921 skipwhite skipempty
syntax region asemeComment_921 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_919,asemeComment_921 skipwhite skipempty
syntax match asemeComment_921 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_919,asemeComment_921 skipwhite skipempty
syntax match asemeReference_919 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_917 /\vwrites%(<|>)/ contained nextgroup=asemeReference_916,asemeComment_918 skipwhite skipempty
syntax region asemeComment_918 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_916,asemeComment_918 skipwhite skipempty
syntax match asemeComment_918 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_916,asemeComment_918 skipwhite skipempty
syntax match asemeReference_916 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_914 /\vfor%(<|>)/ contained nextgroup=asemeNumber_913,asemeComment_915 skipwhite skipempty
syntax region asemeComment_915 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_913,asemeComment_915 skipwhite skipempty
syntax match asemeComment_915 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_913,asemeComment_915 skipwhite skipempty
syntax match asemeNumber_913 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeChoice_911 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_910,asemeComment_912 skipwhite skipempty
syntax region asemeComment_912 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_910,asemeComment_912 skipwhite skipempty
syntax match asemeComment_912 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_910,asemeComment_912 skipwhite skipempty
syntax match asemeReference_910 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_908 /\vuses%(<|>)/ contained nextgroup=asemeReference_907,asemeComment_909 skipwhite skipempty
syntax region asemeComment_909 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_907,asemeComment_909 skipwhite skipempty
syntax match asemeComment_909 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_907,asemeComment_909 skipwhite skipempty
syntax match asemeReference_907 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_905 /\vas%(<|>)/ contained nextgroup=asemeChoice_904,asemeComment_906 skipwhite skipempty
syntax region asemeComment_906 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_904,asemeComment_906 skipwhite skipempty
syntax match asemeComment_906 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_904,asemeComment_906 skipwhite skipempty
syntax match asemeChoice_904 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_902 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_901,asemeComment_903 skipwhite skipempty
syntax region asemeComment_903 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_901,asemeComment_903 skipwhite skipempty
syntax match asemeComment_903 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_901,asemeComment_903 skipwhite skipempty
syntax match asemeNumber_901 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_899 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_898,asemeComment_900 skipwhite skipempty
syntax region asemeComment_900 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_898,asemeComment_900 skipwhite skipempty
syntax match asemeComment_900 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_898,asemeComment_900 skipwhite skipempty
syntax match asemeNumber_898 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_896 /\vevery%(<|>)/ contained nextgroup=asemeNumber_895,asemeComment_897 skipwhite skipempty
syntax region asemeComment_897 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_895,asemeComment_897 skipwhite skipempty
syntax match asemeComment_897 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_895,asemeComment_897 skipwhite skipempty
syntax match asemeNumber_895 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeClause_893 /\vreads%(<|>)/ contained nextgroup=asemeChoice_890,asemeReference_892,asemeComment_894 skipwhite skipempty
syntax region asemeComment_894 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_890,asemeReference_892,asemeComment_894 skipwhite skipempty
syntax match asemeComment_894 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_890,asemeReference_892,asemeComment_894 skipwhite skipempty
syntax match asemeReference_892 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeChoice_890 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_888,asemeComment_891 skipwhite skipempty
syntax region asemeComment_891 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_888,asemeComment_891 skipwhite skipempty
syntax match asemeComment_891 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_888,asemeComment_891 skipwhite skipempty
syntax match asemeReference_888 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax region asemeComment_889 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeComment_889 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_889 skipwhite skipempty
syntax match asemeDeclaration_886 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_887 skipwhite skipempty
syntax region asemeComment_887 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_887 skipwhite skipempty
syntax match asemeComment_887 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_887 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_885
syntax region asemePunctuation_885 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_884,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_884 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_824,asemeClause_827,asemeClause_830,asemeClause_833,asemeClause_836,asemeClause_839,asemeChoice_842,asemeClause_845,asemeClause_848,asemeClause_851,asemeClause_853,asemeChoice_854,asemeChoice_855,asemePunctuation_862,asemePunctuation_876,asemePunctuation_880,asemePunctuation_882,asemeReference_883
syntax match asemeReference_883 /\v%(%(%(%(every|takes|simulated|as|uses|reads|writes)%(<|>)|%(within|ends|waits)%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@!%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemePunctuation_882 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemePunctuation_880 /\v\:/ contained nextgroup=asemeBuiltIn_878,asemeType_879,asemeComment_881 skipwhite skipempty
syntax region asemeComment_881 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_878,asemeType_879,asemeComment_881 skipwhite skipempty
syntax match asemeComment_881 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_878,asemeType_879,asemeComment_881 skipwhite skipempty
syntax match asemeType_879 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeBuiltIn_878 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemePunctuation_876 /\v\,/ contained nextgroup=asemeName_868,asemeChoice_871,asemeReference_873,asemeReference_874,asemeReference_875,asemeComment_877 skipwhite skipempty
syntax region asemeComment_877 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_868,asemeChoice_871,asemeReference_873,asemeReference_874,asemeReference_875,asemeComment_877 skipwhite skipempty
syntax match asemeComment_877 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_868,asemeChoice_871,asemeReference_873,asemeReference_874,asemeReference_875,asemeComment_877 skipwhite skipempty
syntax match asemeReference_875 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeReference_874 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeReference_873 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeChoice_871 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_870,asemeComment_872 skipwhite skipempty
syntax region asemeComment_872 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_870,asemeComment_872 skipwhite skipempty
syntax match asemeComment_872 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_870,asemeComment_872 skipwhite skipempty
syntax match asemeReference_870 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeName_868 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_866,asemeComment_869 skipwhite skipempty
syntax region asemeComment_869 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_866,asemeComment_869 skipwhite skipempty
syntax match asemeComment_869 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_866,asemeComment_869 skipwhite skipempty
syntax match asemePunctuation_866 /\v\:/ contained nextgroup=asemeBuiltIn_864,asemeType_865,asemeComment_867 skipwhite skipempty
syntax region asemeComment_867 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_864,asemeType_865,asemeComment_867 skipwhite skipempty
syntax match asemeComment_867 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_864,asemeType_865,asemeComment_867 skipwhite skipempty
syntax match asemeType_865 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeBuiltIn_864 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemePunctuation_862 /\v\(/ contained nextgroup=asemeName_860,asemeComment_863 skipwhite skipempty
syntax region asemeComment_863 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_860,asemeComment_863 skipwhite skipempty
syntax match asemeComment_863 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_860,asemeComment_863 skipwhite skipempty
syntax match asemeName_860 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_858,asemeComment_861 skipwhite skipempty
syntax region asemeComment_861 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_858,asemeComment_861 skipwhite skipempty
syntax match asemeComment_861 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_858,asemeComment_861 skipwhite skipempty
syntax match asemePunctuation_858 /\v\:/ contained nextgroup=asemeBuiltIn_856,asemeType_857,asemeComment_859 skipwhite skipempty
syntax region asemeComment_859 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_856,asemeType_857,asemeComment_859 skipwhite skipempty
syntax match asemeComment_859 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_856,asemeType_857,asemeComment_859 skipwhite skipempty
syntax match asemeType_857 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeBuiltIn_856 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeChoice_855 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeChoice_854 /\vwaits%(<|>)%(\_s+%(every|takes|simulated|as|uses|reads|writes)%(<|>))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_853 /\vsimulated%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_851 /\vends%(<|>)/ contained nextgroup=asemeReference_850,asemeComment_852 skipwhite skipempty
syntax region asemeComment_852 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_850,asemeComment_852 skipwhite skipempty
syntax match asemeComment_852 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_850,asemeComment_852 skipwhite skipempty
syntax match asemeReference_850 /\v%(%(every|takes|simulated|as|uses|reads|writes)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_848 /\vwrites%(<|>)/ contained nextgroup=asemeReference_847,asemeComment_849 skipwhite skipempty
syntax region asemeComment_849 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_847,asemeComment_849 skipwhite skipempty
syntax match asemeComment_849 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_847,asemeComment_849 skipwhite skipempty
syntax match asemeReference_847 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_845 /\vfor%(<|>)/ contained nextgroup=asemeNumber_844,asemeComment_846 skipwhite skipempty
syntax region asemeComment_846 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_844,asemeComment_846 skipwhite skipempty
syntax match asemeComment_846 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_844,asemeComment_846 skipwhite skipempty
syntax match asemeNumber_844 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeChoice_842 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_841,asemeComment_843 skipwhite skipempty
syntax region asemeComment_843 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_841,asemeComment_843 skipwhite skipempty
syntax match asemeComment_843 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_841,asemeComment_843 skipwhite skipempty
syntax match asemeReference_841 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_839 /\vuses%(<|>)/ contained nextgroup=asemeReference_838,asemeComment_840 skipwhite skipempty
syntax region asemeComment_840 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_838,asemeComment_840 skipwhite skipempty
syntax match asemeComment_840 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_838,asemeComment_840 skipwhite skipempty
syntax match asemeReference_838 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_836 /\vas%(<|>)/ contained nextgroup=asemeChoice_835,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_835,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_835,asemeComment_837 skipwhite skipempty
syntax match asemeChoice_835 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_833 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_832,asemeComment_834 skipwhite skipempty
syntax region asemeComment_834 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_832,asemeComment_834 skipwhite skipempty
syntax match asemeComment_834 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_832,asemeComment_834 skipwhite skipempty
syntax match asemeNumber_832 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_830 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_829,asemeComment_831 skipwhite skipempty
syntax region asemeComment_831 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_829,asemeComment_831 skipwhite skipempty
syntax match asemeComment_831 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_829,asemeComment_831 skipwhite skipempty
syntax match asemeNumber_829 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_827 /\vevery%(<|>)/ contained nextgroup=asemeNumber_826,asemeComment_828 skipwhite skipempty
syntax region asemeComment_828 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_826,asemeComment_828 skipwhite skipempty
syntax match asemeComment_828 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_826,asemeComment_828 skipwhite skipempty
syntax match asemeNumber_826 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeClause_824 /\vreads%(<|>)/ contained nextgroup=asemeChoice_821,asemeReference_823,asemeComment_825 skipwhite skipempty
syntax region asemeComment_825 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_821,asemeReference_823,asemeComment_825 skipwhite skipempty
syntax match asemeComment_825 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_821,asemeReference_823,asemeComment_825 skipwhite skipempty
syntax match asemeReference_823 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeChoice_821 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_819,asemeComment_822 skipwhite skipempty
syntax region asemeComment_822 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_819,asemeComment_822 skipwhite skipempty
syntax match asemeComment_822 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_819,asemeComment_822 skipwhite skipempty
syntax match asemeReference_819 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|[ \t]*[\r\n]\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|simulated|waits|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax region asemeComment_820 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeComment_820 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_820 skipwhite skipempty
syntax match asemeDeclaration_817 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_818 skipwhite skipempty
syntax region asemeComment_818 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_818 skipwhite skipempty
syntax match asemeComment_818 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_818 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_816
syntax region asemePunctuation_816 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_815,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_815 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_797,asemePunctuation_801,asemePunctuation_804,asemePunctuation_806,asemeOperator_814
syntax match asemeOperator_814 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemePunctuation_806 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax match asemePunctuation_804 /\v\,/ contained nextgroup=asemeName_803,asemeComment_805 skipwhite skipempty
syntax region asemeComment_805 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_803,asemeComment_805 skipwhite skipempty
syntax match asemeComment_805 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_803,asemeComment_805 skipwhite skipempty
syntax match asemeName_803 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax match asemePunctuation_801 /\v\:/ contained nextgroup=asemeBuiltIn_799,asemeType_800,asemeComment_802 skipwhite skipempty
syntax region asemeComment_802 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_799,asemeType_800,asemeComment_802 skipwhite skipempty
syntax match asemeComment_802 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_799,asemeType_800,asemeComment_802 skipwhite skipempty
syntax match asemeType_800 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax match asemeBuiltIn_799 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax match asemePunctuation_797 /\v\(/ contained nextgroup=asemeName_795,asemeComment_798 skipwhite skipempty
syntax region asemeComment_798 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_795,asemeComment_798 skipwhite skipempty
syntax match asemeComment_798 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_795,asemeComment_798 skipwhite skipempty
syntax match asemeName_795 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax region asemeComment_796 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax match asemeComment_796 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_796 skipwhite skipempty
syntax match asemeDeclaration_793 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_791,asemeComment_794 skipwhite skipempty
syntax region asemeComment_794 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_791,asemeComment_794 skipwhite skipempty
syntax match asemeComment_794 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_791,asemeComment_794 skipwhite skipempty
syntax match asemeName_791 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_790,asemeComment_792 skipwhite skipempty
syntax region asemeComment_792 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_790,asemeComment_792 skipwhite skipempty
syntax match asemeComment_792 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_790,asemeComment_792 skipwhite skipempty
syntax match asemeOperator_790 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_788 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_786,asemeComment_789 skipwhite skipempty
syntax region asemeComment_789 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_786,asemeComment_789 skipwhite skipempty
syntax match asemeComment_789 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_786,asemeComment_789 skipwhite skipempty
syntax match asemeName_786 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_784,asemeComment_787 skipwhite skipempty
syntax region asemeComment_787 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_784,asemeComment_787 skipwhite skipempty
syntax match asemeComment_787 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_784,asemeComment_787 skipwhite skipempty
syntax match asemePunctuation_784 /\v\:/ contained nextgroup=asemeBuiltIn_782,asemeType_783,asemeComment_785 skipwhite skipempty
syntax region asemeComment_785 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_782,asemeType_783,asemeComment_785 skipwhite skipempty
syntax match asemeComment_785 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_782,asemeType_783,asemeComment_785 skipwhite skipempty
syntax match asemeType_783 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeBuiltIn_782 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_740,asemeOperator_773,asemeName_778,asemeBuiltIn_780,asemeType_781
syntax match asemeType_781 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeBuiltIn_780 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeName_778 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_776,asemeComment_779 skipwhite skipempty
syntax region asemeComment_779 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_776,asemeComment_779 skipwhite skipempty
syntax match asemeComment_779 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_776,asemeComment_779 skipwhite skipempty
syntax match asemePunctuation_776 /\v\:/ contained nextgroup=asemeBuiltIn_774,asemeType_775,asemeComment_777 skipwhite skipempty
syntax region asemeComment_777 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_774,asemeType_775,asemeComment_777 skipwhite skipempty
syntax match asemeComment_777 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_774,asemeType_775,asemeComment_777 skipwhite skipempty
syntax match asemeType_775 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeBuiltIn_774 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeOperator_773 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemePunctuation_740 /\v\:/ contained nextgroup=asemeBuiltIn_737,asemeType_739,asemeComment_741 skipwhite skipempty
syntax region asemeComment_741 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_737,asemeType_739,asemeComment_741 skipwhite skipempty
syntax match asemeComment_741 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_737,asemeType_739,asemeComment_741 skipwhite skipempty
syntax match asemeType_739 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeBuiltIn_737 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax region asemeComment_738 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeComment_738 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_738 skipwhite skipempty
syntax match asemeDeclaration_735 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_733,asemeComment_736 skipwhite skipempty
syntax region asemeComment_736 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_733,asemeComment_736 skipwhite skipempty
syntax match asemeComment_736 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_733,asemeComment_736 skipwhite skipempty
syntax match asemeName_733 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_732,@asemeCapabilityInBodyOfSrm,asemeComment_734 skipwhite skipempty
syntax region asemeComment_734 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_732,@asemeCapabilityInBodyOfSrm,asemeComment_734 skipwhite skipempty
syntax match asemeComment_734 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_732,@asemeCapabilityInBodyOfSrm,asemeComment_734 skipwhite skipempty
syntax match asemeText_732 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_723,asemePunctuation_726,asemeText_728,asemeName_730
syntax match asemeName_730 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_729,@asemeCapabilityInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_729,@asemeCapabilityInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_729,@asemeCapabilityInBodyOfSrm,asemeComment_731 skipwhite skipempty
syntax match asemeText_729 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemeText_728 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemePunctuation_726 /\v\,/ contained nextgroup=asemeReference_725,asemeComment_727 skipwhite skipempty
syntax region asemeComment_727 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_725,asemeComment_727 skipwhite skipempty
syntax match asemeComment_727 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_725,asemeComment_727 skipwhite skipempty
syntax match asemeReference_725 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemeOperator_723 /\v\=%(\=)@!/ contained nextgroup=asemeReference_721,asemeComment_724 skipwhite skipempty
syntax region asemeComment_724 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_721,asemeComment_724 skipwhite skipempty
syntax match asemeComment_724 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_721,asemeComment_724 skipwhite skipempty
syntax match asemeReference_721 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax region asemeComment_722 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemeComment_722 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_722 skipwhite skipempty
syntax match asemeDeclaration_719 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax match asemeReference_717 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_715,asemeComment_718 skipwhite skipempty
syntax region asemeComment_718 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_715,asemeComment_718 skipwhite skipempty
syntax match asemeComment_718 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_715,asemeComment_718 skipwhite skipempty
syntax match asemePunctuation_715 /\v\./ contained nextgroup=asemeReference_714,asemeComment_716 skipwhite skipempty
syntax region asemeComment_716 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_714,asemeComment_716 skipwhite skipempty
syntax match asemeComment_716 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_714,asemeComment_716 skipwhite skipempty
syntax match asemeReference_714 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_691,asemeClause_695,asemePunctuation_703,asemePunctuation_706,asemeOperator_708,asemeReference_712
syntax match asemeReference_712 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_710,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax region asemeComment_713 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_710,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemeComment_713 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_710,@asemePlaysInBodyOfSrm,asemeComment_713 skipwhite skipempty
syntax match asemePunctuation_710 /\v\./ contained nextgroup=asemeReference_709,asemeComment_711 skipwhite skipempty
syntax region asemeComment_711 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_709,asemeComment_711 skipwhite skipempty
syntax match asemeComment_711 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_709,asemeComment_711 skipwhite skipempty
syntax match asemeReference_709 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax match asemeOperator_708 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemePunctuation_706 /\v\./ contained nextgroup=asemeReference_705,asemeComment_707 skipwhite skipempty
syntax region asemeComment_707 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_705,asemeComment_707 skipwhite skipempty
syntax match asemeComment_707 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_705,asemeComment_707 skipwhite skipempty
syntax match asemeReference_705 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax match asemePunctuation_703 /\v\,/ contained nextgroup=asemeReference_701,asemeComment_704 skipwhite skipempty
syntax region asemeComment_704 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_701,asemeComment_704 skipwhite skipempty
syntax match asemeComment_704 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_701,asemeComment_704 skipwhite skipempty
syntax match asemeReference_701 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\.|\=%(\=)@!))@=/ contained nextgroup=asemePunctuation_698,asemeOperator_700,asemeComment_702 skipwhite skipempty
syntax region asemeComment_702 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_698,asemeOperator_700,asemeComment_702 skipwhite skipempty
syntax match asemeComment_702 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_698,asemeOperator_700,asemeComment_702 skipwhite skipempty
syntax match asemeOperator_700 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemePunctuation_698 /\v\./ contained nextgroup=asemeReference_697,asemeComment_699 skipwhite skipempty
syntax region asemeComment_699 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_697,asemeComment_699 skipwhite skipempty
syntax match asemeComment_699 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_697,asemeComment_699 skipwhite skipempty
syntax match asemeReference_697 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax match asemeClause_695 /\vas%(<|>)/ contained nextgroup=asemeReference_693,asemeComment_696 skipwhite skipempty
syntax region asemeComment_696 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_693,asemeComment_696 skipwhite skipempty
syntax match asemeComment_696 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_693,asemeComment_696 skipwhite skipempty
syntax match asemeReference_693 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_694 skipwhite skipempty
syntax match asemeClause_691 /\vwith%(<|>)/ contained nextgroup=asemeReference_689,asemeComment_692 skipwhite skipempty
syntax region asemeComment_692 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_689,asemeComment_692 skipwhite skipempty
syntax match asemeComment_692 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_689,asemeComment_692 skipwhite skipempty
syntax match asemeReference_689 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_688,asemeComment_690 skipwhite skipempty
syntax region asemeComment_690 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_688,asemeComment_690 skipwhite skipempty
syntax match asemeComment_690 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_688,asemeComment_690 skipwhite skipempty
syntax match asemeOperator_688 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeDeclaration_655 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_654,asemeComment_656 skipwhite skipempty
syntax region asemeComment_656 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_654,asemeComment_656 skipwhite skipempty
syntax match asemeComment_656 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_654,asemeComment_656 skipwhite skipempty
syntax match asemeReference_654 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_650 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_651,asemeReference_653
syntax match asemeReference_653 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_650 skipwhite skipempty
syntax match asemePunctuation_651 /\v\,/ contained nextgroup=asemeReference_649,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_649,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_649,asemeComment_652 skipwhite skipempty
syntax match asemeReference_649 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_650 skipwhite skipempty
syntax region asemeComment_650 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_650 skipwhite skipempty
syntax match asemeComment_650 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_650 skipwhite skipempty
syntax match asemeClause_647 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_645,asemeComment_648 skipwhite skipempty
syntax region asemeComment_648 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_645,asemeComment_648 skipwhite skipempty
syntax match asemeComment_648 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_645,asemeComment_648 skipwhite skipempty
syntax match asemeBlock_645 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_646 skipwhite skipempty
syntax match asemeDeclaration_643 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_642,asemeComment_644 skipwhite skipempty
syntax region asemeComment_644 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_642,asemeComment_644 skipwhite skipempty
syntax match asemeComment_644 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_642,asemeComment_644 skipwhite skipempty
syntax match asemeBlock_642 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_641 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_639,asemeBlock_640
syntax match asemeBlock_640 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_641 skipwhite skipempty
syntax region asemeComment_641 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_641 skipwhite skipempty
syntax match asemeComment_641 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_641 skipwhite skipempty
syntax region asemePunctuation_639 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_493,asemeDeclaration_496,asemeDeclaration_529,asemeDeclaration_533,asemeDeclaration_637,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeDeclaration_637 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_635,asemeComment_638 skipwhite skipempty
syntax region asemeComment_638 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_635,asemeComment_638 skipwhite skipempty
syntax match asemeComment_638 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_635,asemeComment_638 skipwhite skipempty
syntax match asemeBlock_635 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_632,asemeOperator_634,@asemeControlInBodyOfAip,asemeComment_636 skipwhite skipempty
syntax region asemeComment_636 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_632,asemeOperator_634,@asemeControlInBodyOfAip,asemeComment_636 skipwhite skipempty
syntax match asemeComment_636 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_632,asemeOperator_634,@asemeControlInBodyOfAip,asemeComment_636 skipwhite skipempty
syntax match asemeOperator_634 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax match asemeOperator_632 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_631,@asemeControlInBodyOfAip,asemeComment_633 skipwhite skipempty
syntax region asemeComment_633 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_631,@asemeControlInBodyOfAip,asemeComment_633 skipwhite skipempty
syntax match asemeComment_633 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_631,@asemeControlInBodyOfAip,asemeComment_633 skipwhite skipempty
syntax match asemeOperator_631 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemeOperator_537,asemePunctuation_623,asemeOperator_624,asemeBlock_629
syntax match asemeBlock_629 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_626,asemeOperator_628,@asemeControlInBodyOfAip,asemeComment_630 skipwhite skipempty
syntax region asemeComment_630 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_626,asemeOperator_628,@asemeControlInBodyOfAip,asemeComment_630 skipwhite skipempty
syntax match asemeComment_630 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_626,asemeOperator_628,@asemeControlInBodyOfAip,asemeComment_630 skipwhite skipempty
syntax match asemeOperator_628 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax match asemeOperator_626 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_625,@asemeControlInBodyOfAip,asemeComment_627 skipwhite skipempty
syntax region asemeComment_627 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_625,@asemeControlInBodyOfAip,asemeComment_627 skipwhite skipempty
syntax match asemeComment_627 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_625,@asemeControlInBodyOfAip,asemeComment_627 skipwhite skipempty
syntax match asemeOperator_625 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax match asemeOperator_624 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax region asemePunctuation_623 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_584,asemeNumber_621,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeNumber_621 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_619,asemeComment_622 skipwhite skipempty
syntax region asemeComment_622 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_619,asemeComment_622 skipwhite skipempty
syntax match asemeComment_622 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_619,asemeComment_622 skipwhite skipempty
syntax match asemeOperator_619 /\v\-\>/ contained nextgroup=asemeNumber_617,asemeComment_620 skipwhite skipempty
syntax region asemeComment_620 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_617,asemeComment_620 skipwhite skipempty
syntax match asemeComment_620 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_617,asemeComment_620 skipwhite skipempty
syntax match asemeNumber_617 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax region asemeComment_618 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax match asemeComment_618 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_616,asemeComment_618 skipwhite skipempty
syntax match asemePunctuation_616 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeDeclaration_584 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_541,asemeOperator_544,asemePunctuation_577,asemeText_578,asemeNumber_579,asemeReference_580,asemeNumber_581,asemeOperator_582,asemePunctuation_583
syntax match asemePunctuation_583 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeOperator_582 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeNumber_581 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeReference_580 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeNumber_579 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeText_578 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,?])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemePunctuation_577 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeOperator_544 /\v\#/ contained nextgroup=asemeNumber_543,asemeComment_545 skipwhite skipempty
syntax region asemeComment_545 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_543,asemeComment_545 skipwhite skipempty
syntax match asemeComment_545 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_543,asemeComment_545 skipwhite skipempty
syntax match asemeNumber_543 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeClause_541 /\vevery%(<|>)/ contained nextgroup=asemeNumber_539,asemeComment_542 skipwhite skipempty
syntax region asemeComment_542 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_539,asemeComment_542 skipwhite skipempty
syntax match asemeComment_542 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_539,asemeComment_542 skipwhite skipempty
syntax match asemeNumber_539 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax region asemeComment_540 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeComment_540 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_540 skipwhite skipempty
syntax match asemeOperator_537 /\vreactive%(<|>)/ contained nextgroup=asemeOperator_535,@asemeControlInBodyOfAip,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_535,@asemeControlInBodyOfAip,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_535,@asemeControlInBodyOfAip,asemeComment_538 skipwhite skipempty
syntax match asemeOperator_535 /\vfirst%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax region asemeComment_536 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax match asemeComment_536 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_536 skipwhite skipempty
syntax match asemeDeclaration_533 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax region asemeComment_534 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax match asemeComment_534 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_531,asemeComment_534 skipwhite skipempty
syntax match asemeName_531 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_530,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_530,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_530,asemeComment_532 skipwhite skipempty
syntax match asemeOperator_530 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_529 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_503,asemeClause_507,asemeClause_510,asemeClause_513,asemeClause_516,asemeClause_518,asemeClause_519,asemeClause_520,asemePunctuation_522,asemeOperator_525,asemePunctuation_527,asemeName_528
syntax match asemeName_528 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemePunctuation_527 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeOperator_525 /\v\@/ contained nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax region asemeComment_526 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeComment_526 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeReference_524 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemePunctuation_522 /\v\(/ contained nextgroup=asemeName_521,asemeComment_523 skipwhite skipempty
syntax region asemeComment_523 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_521,asemeComment_523 skipwhite skipempty
syntax match asemeComment_523 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_521,asemeComment_523 skipwhite skipempty
syntax match asemeName_521 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_520 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_519 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_518 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_516 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_515,asemeComment_517 skipwhite skipempty
syntax region asemeComment_517 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_515,asemeComment_517 skipwhite skipempty
syntax match asemeComment_517 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_515,asemeComment_517 skipwhite skipempty
syntax match asemeNumber_515 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_513 /\vleads%(<|>)/ contained nextgroup=asemeClause_512,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_512,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_512,asemeComment_514 skipwhite skipempty
syntax match asemeClause_512 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_510 /\vor%(<|>)/ contained nextgroup=asemeName_509,asemeComment_511 skipwhite skipempty
syntax region asemeComment_511 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_509,asemeComment_511 skipwhite skipempty
syntax match asemeComment_511 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_509,asemeComment_511 skipwhite skipempty
syntax match asemeName_509 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_507 /\vmost%(<|>)/ contained nextgroup=asemeChoice_505,asemeNumber_506,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_505,asemeNumber_506,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_505,asemeNumber_506,asemeComment_508 skipwhite skipempty
syntax match asemeNumber_506 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeChoice_505 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeClause_503 /\vat%(<|>)/ contained nextgroup=asemeClause_501,asemeComment_504 skipwhite skipempty
syntax region asemeComment_504 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_501,asemeComment_504 skipwhite skipempty
syntax match asemeComment_504 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_501,asemeComment_504 skipwhite skipempty
syntax match asemeClause_501 /\vmost%(<|>)/ contained nextgroup=asemeChoice_498,asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax region asemeComment_502 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_498,asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax match asemeComment_502 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_498,asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax match asemeNumber_500 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeChoice_498 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_499 skipwhite skipempty
syntax match asemeDeclaration_496 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_495,asemeComment_497 skipwhite skipempty
syntax region asemeComment_497 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_495,asemeComment_497 skipwhite skipempty
syntax match asemeComment_497 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_495,asemeComment_497 skipwhite skipempty
syntax match asemeText_495 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_493 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_492,asemeComment_494 skipwhite skipempty
syntax region asemeComment_494 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_492,asemeComment_494 skipwhite skipempty
syntax match asemeComment_494 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_492,asemeComment_494 skipwhite skipempty
syntax match asemeBlock_492 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_242,asemePunctuation_245,asemePunctuation_247,asemePunctuation_490,asemeBlock_491
syntax match asemeBlock_491 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_241 skipwhite skipempty
syntax region asemePunctuation_490 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_249,asemeDeclaration_313,asemeDeclaration_366,asemeDeclaration_374,asemeDeclaration_427,asemeDeclaration_432,asemeDeclaration_453,asemeDeclaration_467,asemeName_489,asemeText_30,asemeText_31,asemeNumber_32,asemeReference_33,asemeReference_34,asemePunctuation_35,asemeComment
syntax match asemeName_489 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_471,asemePunctuation_475,asemePunctuation_478,asemePunctuation_480,asemeOperator_488
syntax match asemeOperator_488 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemePunctuation_480 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax match asemePunctuation_478 /\v\,/ contained nextgroup=asemeName_477,asemeComment_479 skipwhite skipempty
syntax region asemeComment_479 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_477,asemeComment_479 skipwhite skipempty
syntax match asemeComment_479 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_477,asemeComment_479 skipwhite skipempty
syntax match asemeName_477 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax match asemePunctuation_475 /\v\:/ contained nextgroup=asemeBuiltIn_473,asemeType_474,asemeComment_476 skipwhite skipempty
syntax region asemeComment_476 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_473,asemeType_474,asemeComment_476 skipwhite skipempty
syntax match asemeComment_476 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_473,asemeType_474,asemeComment_476 skipwhite skipempty
syntax match asemeType_474 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax match asemeBuiltIn_473 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax match asemePunctuation_471 /\v\(/ contained nextgroup=asemeName_469,asemeComment_472 skipwhite skipempty
syntax region asemeComment_472 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_469,asemeComment_472 skipwhite skipempty
syntax match asemeComment_472 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_469,asemeComment_472 skipwhite skipempty
syntax match asemeName_469 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax region asemeComment_470 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax match asemeComment_470 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_470 skipwhite skipempty
syntax match asemeDeclaration_467 /\v%(receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_465,asemeComment_468 skipwhite skipempty
syntax region asemeComment_468 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_465,asemeComment_468 skipwhite skipempty
syntax match asemeComment_468 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_465,asemeComment_468 skipwhite skipempty
syntax match asemeReference_465 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_464,asemeComment_466 skipwhite skipempty
syntax region asemeComment_466 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_464,asemeComment_466 skipwhite skipempty
syntax match asemeComment_466 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_464,asemeComment_466 skipwhite skipempty
syntax match asemeReference_464 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_456 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_459,asemeReference_462
syntax match asemeReference_462 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_461,@asemeReceivesInBodyOfParticipant,asemeComment_463 skipwhite skipempty
syntax region asemeComment_463 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_461,@asemeReceivesInBodyOfParticipant,asemeComment_463 skipwhite skipempty
syntax match asemeComment_463 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_461,@asemeReceivesInBodyOfParticipant,asemeComment_463 skipwhite skipempty
syntax match asemeReference_461 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_456 skipwhite skipempty
syntax match asemePunctuation_459 /\v\,/ contained nextgroup=asemeReference_457,asemeComment_460 skipwhite skipempty
syntax region asemeComment_460 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_457,asemeComment_460 skipwhite skipempty
syntax match asemeComment_460 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_457,asemeComment_460 skipwhite skipempty
syntax match asemeReference_457 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_455,asemeComment_458 skipwhite skipempty
syntax region asemeComment_458 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_455,asemeComment_458 skipwhite skipempty
syntax match asemeComment_458 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_455,asemeComment_458 skipwhite skipempty
syntax match asemeReference_455 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_456 skipwhite skipempty
syntax region asemeComment_456 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_456 skipwhite skipempty
syntax match asemeComment_456 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_456 skipwhite skipempty
syntax match asemeDeclaration_453 /\v%(sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_451,asemeComment_454 skipwhite skipempty
syntax region asemeComment_454 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_451,asemeComment_454 skipwhite skipempty
syntax match asemeComment_454 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_451,asemeComment_454 skipwhite skipempty
syntax match asemeReference_451 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_450,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_450,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_450,asemeComment_452 skipwhite skipempty
syntax match asemeReference_450 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemeClause_436,asemeClause_439,asemeClause_441,asemePunctuation_445,asemeReference_448
syntax match asemeReference_448 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_447,@asemeSendsInBodyOfParticipant,asemeComment_449 skipwhite skipempty
syntax region asemeComment_449 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_447,@asemeSendsInBodyOfParticipant,asemeComment_449 skipwhite skipempty
syntax match asemeComment_449 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_447,@asemeSendsInBodyOfParticipant,asemeComment_449 skipwhite skipempty
syntax match asemeReference_447 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemePunctuation_445 /\v\,/ contained nextgroup=asemeReference_443,asemeComment_446 skipwhite skipempty
syntax region asemeComment_446 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_443,asemeComment_446 skipwhite skipempty
syntax match asemeComment_446 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_443,asemeComment_446 skipwhite skipempty
syntax match asemeReference_443 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_442,asemeComment_444 skipwhite skipempty
syntax region asemeComment_444 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_442,asemeComment_444 skipwhite skipempty
syntax match asemeComment_444 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_442,asemeComment_444 skipwhite skipempty
syntax match asemeReference_442 /\v%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeClause_441 /\vrepeatedly%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeClause_439 /\vor%(<|>)/ contained nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax region asemeComment_440 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax match asemeComment_440 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax match asemeReference_438 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeClause_436 /\vby%(<|>)/ contained nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax match asemeReference_434 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax region asemeComment_435 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeComment_435 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_435 skipwhite skipempty
syntax match asemeDeclaration_432 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_430,asemeComment_433 skipwhite skipempty
syntax region asemeComment_433 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_430,asemeComment_433 skipwhite skipempty
syntax match asemeComment_433 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_430,asemeComment_433 skipwhite skipempty
syntax match asemeName_430 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_429,asemeComment_431 skipwhite skipempty
syntax region asemeComment_431 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_429,asemeComment_431 skipwhite skipempty
syntax match asemeComment_431 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_429,asemeComment_431 skipwhite skipempty
syntax match asemeOperator_429 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_36 skipwhite skipempty
syntax match asemeDeclaration_427 /\v%(result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=result%(<|>)/ contained nextgroup=asemeName_425,asemeComment_428 skipwhite skipempty
syntax region asemeComment_428 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_425,asemeComment_428 skipwhite skipempty
syntax match asemeComment_428 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_425,asemeComment_428 skipwhite skipempty
syntax match asemeName_425 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_423,asemeComment_426 skipwhite skipempty
syntax region asemeComment_426 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_423,asemeComment_426 skipwhite skipempty
syntax match asemeComment_426 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_423,asemeComment_426 skipwhite skipempty
syntax match asemePunctuation_423 /\v\:/ contained nextgroup=asemeBuiltIn_421,asemeType_422,asemeComment_424 skipwhite skipempty
syntax region asemeComment_424 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_421,asemeType_422,asemeComment_424 skipwhite skipempty
syntax match asemeComment_424 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_421,asemeType_422,asemeComment_424 skipwhite skipempty
syntax match asemeType_422 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeBuiltIn_421 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax cluster asemeResultInBodyOfParticipant contains=asemePunctuation_379,asemeOperator_412,asemeName_417,asemeBuiltIn_419,asemeType_420
syntax match asemeType_420 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeBuiltIn_419 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeName_417 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_415,asemeComment_418 skipwhite skipempty
syntax region asemeComment_418 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_415,asemeComment_418 skipwhite skipempty
syntax match asemeComment_418 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_415,asemeComment_418 skipwhite skipempty
syntax match asemePunctuation_415 /\v\:/ contained nextgroup=asemeBuiltIn_413,asemeType_414,asemeComment_416 skipwhite skipempty
syntax region asemeComment_416 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_413,asemeType_414,asemeComment_416 skipwhite skipempty
syntax match asemeComment_416 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_413,asemeType_414,asemeComment_416 skipwhite skipempty
syntax match asemeType_414 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeBuiltIn_413 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeOperator_412 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemePunctuation_379 /\v\:/ contained nextgroup=asemeBuiltIn_376,asemeType_378,asemeComment_380 skipwhite skipempty
syntax region asemeComment_380 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_376,asemeType_378,asemeComment_380 skipwhite skipempty
syntax match asemeComment_380 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_376,asemeType_378,asemeComment_380 skipwhite skipempty
syntax match asemeType_378 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeBuiltIn_376 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax region asemeComment_377 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeComment_377 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeResultInBodyOfParticipant,asemeComment_377 skipwhite skipempty
syntax match asemeDeclaration_374 /\v%(given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=given%(<|>)/ contained nextgroup=asemeName_372,asemeComment_375 skipwhite skipempty
syntax region asemeComment_375 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_372,asemeComment_375 skipwhite skipempty
syntax match asemeComment_375 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_372,asemeComment_375 skipwhite skipempty
syntax match asemeName_372 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_370,asemeComment_373 skipwhite skipempty
syntax region asemeComment_373 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_370,asemeComment_373 skipwhite skipempty
syntax match asemeComment_373 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_370,asemeComment_373 skipwhite skipempty
syntax match asemePunctuation_370 /\v\:/ contained nextgroup=asemeBuiltIn_368,asemeType_369,asemeComment_371 skipwhite skipempty
syntax region asemeComment_371 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_368,asemeType_369,asemeComment_371 skipwhite skipempty
syntax match asemeComment_371 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_368,asemeType_369,asemeComment_371 skipwhite skipempty
syntax match asemeType_369 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained
syntax match asemeBuiltIn_368 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained
syntax match asemeDeclaration_366 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_364,asemeComment_367 skipwhite skipempty
syntax region asemeComment_367 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_364,asemeComment_367 skipwhite skipempty
syntax match asemeComment_367 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_364,asemeComment_367 skipwhite skipempty
syntax match asemeName_364 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_362,asemeComment_365 skipwhite skipempty
syntax region asemeComment_365 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_362,asemeComment_365 skipwhite skipempty
syntax match asemeComment_365 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_362,asemeComment_365 skipwhite skipempty
syntax match asemePunctuation_362 /\v\:/ contained nextgroup=asemeBuiltIn_360,asemeType_361,asemeComment_363 skipwhite skipempty
syntax region asemeComment_363 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_360,asemeType_361,asemeComment_363 skipwhite skipempty
syntax match asemeComment_363 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_360,asemeType_361,asemeComment_363 skipwhite skipempty
syntax match asemeType_361 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeBuiltIn_360 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemePunctuation_318,asemeOperator_351,asemeName_356,asemeBuiltIn_358,asemeType_359
syntax match asemeType_359 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeBuiltIn_358 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeName_356 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_354,asemeComment_357 skipwhite skipempty
syntax region asemeComment_357 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_354,asemeComment_357 skipwhite skipempty
syntax match asemeComment_357 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_354,asemeComment_357 skipwhite skipempty
syntax match asemePunctuation_354 /\v\:/ contained nextgroup=asemeBuiltIn_352,asemeType_353,asemeComment_355 skipwhite skipempty
syntax region asemeComment_355 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_352,asemeType_353,asemeComment_355 skipwhite skipempty
syntax match asemeComment_355 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_352,asemeType_353,asemeComment_355 skipwhite skipempty
syntax match asemeType_353 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeBuiltIn_352 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeOperator_351 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemePunctuation_318 /\v\:/ contained nextgroup=asemeBuiltIn_315,asemeType_317,asemeComment_319 skipwhite skipempty
syntax region asemeComment_319 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_315,asemeType_317,asemeComment_319 skipwhite skipempty
syntax match asemeComment_319 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_315,asemeType_317,asemeComment_319 skipwhite skipempty
syntax match asemeType_317 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeBuiltIn_315 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax region asemeComment_316 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeComment_316 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_316 skipwhite skipempty
syntax match asemeDeclaration_313 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_311,asemeComment_314 skipwhite skipempty
syntax region asemeComment_314 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_311,asemeComment_314 skipwhite skipempty
syntax match asemeComment_314 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_311,asemeComment_314 skipwhite skipempty
syntax match asemeReference_311 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_309,asemeComment_312 skipwhite skipempty
syntax region asemeComment_312 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_309,asemeComment_312 skipwhite skipempty
syntax match asemeComment_312 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_309,asemeComment_312 skipwhite skipempty
syntax match asemePunctuation_309 /\v\./ contained nextgroup=asemeReference_308,asemeComment_310 skipwhite skipempty
syntax region asemeComment_310 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_308,asemeComment_310 skipwhite skipempty
syntax match asemeComment_310 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_308,asemeComment_310 skipwhite skipempty
syntax match asemeReference_308 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax cluster asemePlaysInBodyOfParticipant contains=asemeClause_285,asemeClause_289,asemePunctuation_297,asemePunctuation_300,asemeOperator_302,asemeReference_306
syntax match asemeReference_306 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|given%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|result%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(%(engage|var|let|sends|receives|process)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_304,@asemePlaysInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax region asemeComment_307 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_304,@asemePlaysInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemeComment_307 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_304,@asemePlaysInBodyOfParticipant,asemeComment_307 skipwhite skipempty
syntax match asemePunctuation_304 /\v\./ contained nextgroup=asemeReference_303,asemeComment_305 skipwhite skipempty
syntax region asemeComment_305 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_303,asemeComment_305 skipwhite skipempty
syntax match asemeComment_305 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_303,asemeComment_305 skipwhite skipempty
syntax match asemeReference_303 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemeOperator_302 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemePunctuation_300 /\v\./ contained nextgroup=asemeReference_299,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_299,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_299,asemeComment_301 skipwhite skipempty
syntax match asemeReference_299 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
syntax match asemePunctuation_297 /\v\,/ contained nextgroup=asemeReference_295,asemeComment_298 skipwhite skipempty
syntax region asemeComment_298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_295,asemeComment_298 skipwhite skipempty
syntax match asemeComment_298 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_295,asemeComment_298 skipwhite skipempty
syntax match asemeReference_295 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\.|\=%(\=)@!))@=/ contained nextgroup=asemePunctuation_292,asemeOperator_294,asemeComment_296 skipwhite skipempty
syntax region asemeComment_296 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_292,asemeOperator_294,asemeComment_296 skipwhite skipempty
syntax match asemeComment_296 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_292,asemeOperator_294,asemeComment_296 skipwhite skipempty
syntax match asemeOperator_294 /\v\=%(\=)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemePunctuation_292 /\v\./ contained nextgroup=asemeReference_291,asemeComment_293 skipwhite skipempty
syntax region asemeComment_293 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_291,asemeComment_293 skipwhite skipempty
syntax match asemeComment_293 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_291,asemeComment_293 skipwhite skipempty
syntax match asemeReference_291 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfParticipant,asemeComment_288 skipwhite skipempty
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
syntax cluster asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam contains=asemeClause_1120,asemeClause_1123,asemeText_1125,asemeNumber_1126,asemeTruth_1127,asemeLogic_1128,asemeClause_1129,asemeClause_1130,asemeClause_1131,asemeClause_1132,asemeClause_1133,asemeClause_1134,asemeClause_1135,asemeClause_1136,asemeClause_1137,asemeClause_1138,asemeClause_1139,asemeClause_1140,asemeCall_1141,asemeReference_1142,asemeOperator_1143,asemePunctuation_1144
syntax match asemePunctuation_1144 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeOperator_1143 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeReference_1142 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeCall_1141 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1140 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1139 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1138 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1137 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1136 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1135 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1134 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1133 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1132 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1131 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1130 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1129 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeLogic_1128 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeTruth_1127 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeNumber_1126 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeText_1125 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeClause_1123 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1122,asemeComment_1124 skipwhite skipempty
syntax region asemeComment_1124 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1122,asemeComment_1124 skipwhite skipempty
syntax match asemeComment_1124 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1122,asemeComment_1124 skipwhite skipempty
syntax match asemeReference_1122 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1115,asemeComment_1117 skipwhite skipempty
syntax match asemeClause_1120 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1118,asemeComment_1121 skipwhite skipempty
syntax region asemeComment_1121 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1118,asemeComment_1121 skipwhite skipempty
syntax match asemeComment_1121 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1118,asemeComment_1121 skipwhite skipempty
syntax match asemeReference_1118 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1116,asemeComment_1119 skipwhite skipempty
syntax region asemeComment_1119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1116,asemeComment_1119 skipwhite skipempty
syntax match asemeComment_1119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1116,asemeComment_1119 skipwhite skipempty
syntax match asemeReference_1116 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1115,asemeComment_1117 skipwhite skipempty
syntax region asemeComment_1117 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1115,asemeComment_1117 skipwhite skipempty
syntax match asemeComment_1117 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1115,asemeComment_1117 skipwhite skipempty
syntax region asemePunctuation_1115 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax region asemeComment_1114 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax match asemeComment_1114 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingTokenBeforeAsemeAgentsInBodyOfTeam,@asemeAgentsInBodyOfTeam,asemeComment_1114 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart contains=asemeClause_1057,asemeClause_1060,asemeText_1062,asemeNumber_1063,asemeTruth_1064,asemeLogic_1065,asemeClause_1066,asemeClause_1067,asemeClause_1068,asemeClause_1069,asemeClause_1070,asemeClause_1071,asemeClause_1072,asemeClause_1073,asemeClause_1074,asemeClause_1075,asemeClause_1076,asemeClause_1077,asemeCall_1078,asemeReference_1079,asemeOperator_1080,asemePunctuation_1081
syntax match asemePunctuation_1081 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeOperator_1080 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeReference_1079 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeCall_1078 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1077 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1076 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1075 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1074 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1073 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1072 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1071 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1070 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1069 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1068 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1067 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1066 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeLogic_1065 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeTruth_1064 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeNumber_1063 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeText_1062 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeClause_1060 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1059,asemeComment_1061 skipwhite skipempty
syntax region asemeComment_1061 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1059,asemeComment_1061 skipwhite skipempty
syntax match asemeComment_1061 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1059,asemeComment_1061 skipwhite skipempty
syntax match asemeReference_1059 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1052,asemeComment_1054 skipwhite skipempty
syntax match asemeClause_1057 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1055,asemeComment_1058 skipwhite skipempty
syntax region asemeComment_1058 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1055,asemeComment_1058 skipwhite skipempty
syntax match asemeComment_1058 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1055,asemeComment_1058 skipwhite skipempty
syntax match asemeReference_1055 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1053,asemeComment_1056 skipwhite skipempty
syntax region asemeComment_1056 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1053,asemeComment_1056 skipwhite skipempty
syntax match asemeComment_1056 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1053,asemeComment_1056 skipwhite skipempty
syntax match asemeReference_1053 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1052,asemeComment_1054 skipwhite skipempty
syntax region asemeComment_1054 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1052,asemeComment_1054 skipwhite skipempty
syntax match asemeComment_1054 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1052,asemeComment_1054 skipwhite skipempty
syntax region asemePunctuation_1052 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax region asemeComment_1051 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax match asemeComment_1051 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfStatechart,@asemeVarInBodyOfStatechart,asemeComment_1051 skipwhite skipempty
syntax cluster asemeStandingWay contains=asemeClause_1016,asemeClause_1019,asemeText_1021,asemeNumber_1022,asemeTruth_1023,asemeLogic_1024,asemeClause_1025,asemeClause_1026,asemeClause_1027,asemeClause_1028,asemeClause_1029,asemeClause_1030,asemeClause_1031,asemeClause_1032,asemeClause_1033,asemeClause_1034,asemeClause_1035,asemeClause_1036,asemeCall_1037,asemeReference_1038,asemeOperator_1039,asemePunctuation_1040
syntax match asemePunctuation_1040 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeOperator_1039 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeReference_1038 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeCall_1037 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1036 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1035 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1034 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1033 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1032 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1031 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1030 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1029 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1028 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1027 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1026 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1025 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeLogic_1024 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeTruth_1023 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeNumber_1022 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeText_1021 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeClause_1019 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_1018,asemeComment_1020 skipwhite skipempty
syntax region asemeComment_1020 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1018,asemeComment_1020 skipwhite skipempty
syntax match asemeComment_1020 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1018,asemeComment_1020 skipwhite skipempty
syntax match asemeReference_1018 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1011,asemeComment_1013 skipwhite skipempty
syntax match asemeClause_1016 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_1014,asemeComment_1017 skipwhite skipempty
syntax region asemeComment_1017 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1014,asemeComment_1017 skipwhite skipempty
syntax match asemeComment_1017 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1014,asemeComment_1017 skipwhite skipempty
syntax match asemeReference_1014 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_1012,asemeComment_1015 skipwhite skipempty
syntax region asemeComment_1015 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_1012,asemeComment_1015 skipwhite skipempty
syntax match asemeComment_1015 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_1012,asemeComment_1015 skipwhite skipempty
syntax match asemeReference_1012 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_1011,asemeComment_1013 skipwhite skipempty
syntax region asemeComment_1013 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_1011,asemeComment_1013 skipwhite skipempty
syntax match asemeComment_1013 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_1011,asemeComment_1013 skipwhite skipempty
syntax region asemePunctuation_1011 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax region asemeComment_1010 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax match asemeComment_1010 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStandingWay,asemeComment_1010 skipwhite skipempty
syntax cluster asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness contains=asemeText_807,asemeNumber_809,asemeReference_810,asemeNumber_811,asemeOperator_812,asemePunctuation_813
syntax match asemePunctuation_813 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemeOperator_812 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemeNumber_811 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemeReference_810 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemeNumber_809 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemeText_807 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax region asemeComment_808 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax match asemeComment_808 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaTokenBeforeAsemeFormulaInBodyOfLiveness,@asemeFormulaInBodyOfLiveness,asemeComment_808 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfSrm contains=asemeClause_748,asemeClause_751,asemeText_753,asemeNumber_754,asemeTruth_755,asemeLogic_756,asemeClause_757,asemeClause_758,asemeClause_759,asemeClause_760,asemeClause_761,asemeClause_762,asemeClause_763,asemeClause_764,asemeClause_765,asemeClause_766,asemeClause_767,asemeClause_768,asemeCall_769,asemeReference_770,asemeOperator_771,asemePunctuation_772
syntax match asemePunctuation_772 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeOperator_771 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeReference_770 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeCall_769 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_768 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_767 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_766 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_765 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_764 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_763 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_762 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_761 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_760 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_759 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_758 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_757 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeLogic_756 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeTruth_755 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeNumber_754 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeText_753 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeClause_751 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_750,asemeComment_752 skipwhite skipempty
syntax region asemeComment_752 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_750,asemeComment_752 skipwhite skipempty
syntax match asemeComment_752 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_750,asemeComment_752 skipwhite skipempty
syntax match asemeReference_750 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_743,asemeComment_745 skipwhite skipempty
syntax match asemeClause_748 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_746,asemeComment_749 skipwhite skipempty
syntax region asemeComment_749 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_746,asemeComment_749 skipwhite skipempty
syntax match asemeComment_749 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_746,asemeComment_749 skipwhite skipempty
syntax match asemeReference_746 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_744,asemeComment_747 skipwhite skipempty
syntax region asemeComment_747 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_744,asemeComment_747 skipwhite skipempty
syntax match asemeComment_747 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_744,asemeComment_747 skipwhite skipempty
syntax match asemeReference_744 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_743,asemeComment_745 skipwhite skipempty
syntax region asemeComment_745 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_743,asemeComment_745 skipwhite skipempty
syntax match asemeComment_745 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_743,asemeComment_745 skipwhite skipempty
syntax region asemePunctuation_743 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax region asemeComment_742 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax match asemeComment_742 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfSrm,@asemeVarInBodyOfSrm,asemeComment_742 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfSrm contains=asemeClause_663,asemeClause_666,asemeText_668,asemeNumber_669,asemeTruth_670,asemeLogic_671,asemeClause_672,asemeClause_673,asemeClause_674,asemeClause_675,asemeClause_676,asemeClause_677,asemeClause_678,asemeClause_679,asemeClause_680,asemeClause_681,asemeClause_682,asemeClause_683,asemeCall_684,asemeReference_685,asemeOperator_686,asemePunctuation_687
syntax match asemePunctuation_687 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeOperator_686 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeReference_685 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeCall_684 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_683 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_682 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_681 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_680 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_679 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_678 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_677 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_676 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_675 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_674 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_673 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_672 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeLogic_671 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeTruth_670 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeNumber_669 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeText_668 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeClause_666 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_665,asemeComment_667 skipwhite skipempty
syntax region asemeComment_667 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_665,asemeComment_667 skipwhite skipempty
syntax match asemeComment_667 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_665,asemeComment_667 skipwhite skipempty
syntax match asemeReference_665 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_658,asemeComment_660 skipwhite skipempty
syntax match asemeClause_663 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_661,asemeComment_664 skipwhite skipempty
syntax region asemeComment_664 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_661,asemeComment_664 skipwhite skipempty
syntax match asemeComment_664 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_661,asemeComment_664 skipwhite skipempty
syntax match asemeReference_661 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_659,asemeComment_662 skipwhite skipempty
syntax region asemeComment_662 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_659,asemeComment_662 skipwhite skipempty
syntax match asemeComment_662 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_659,asemeComment_662 skipwhite skipempty
syntax match asemeReference_659 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_658,asemeComment_660 skipwhite skipempty
syntax region asemeComment_660 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_658,asemeComment_660 skipwhite skipempty
syntax match asemeComment_660 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_658,asemeComment_660 skipwhite skipempty
syntax region asemePunctuation_658 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax region asemeComment_657 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax match asemeComment_657 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfSrm,@asemePlaysInBodyOfSrm,asemeComment_657 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeClause_591,asemeClause_594,asemeText_596,asemeNumber_597,asemeTruth_598,asemeLogic_599,asemeClause_600,asemeClause_601,asemeClause_602,asemeClause_603,asemeClause_604,asemeClause_605,asemeClause_606,asemeClause_607,asemeClause_608,asemeClause_609,asemeClause_610,asemeClause_611,asemeCall_612,asemeReference_613,asemeOperator_614,asemePunctuation_615
syntax match asemePunctuation_615 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeOperator_614 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeReference_613 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeCall_612 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_611 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_610 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_609 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_608 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_607 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_606 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_605 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_604 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_603 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_602 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_601 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_600 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeLogic_599 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeTruth_598 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeNumber_597 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeText_596 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeClause_594 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_593,asemeComment_595 skipwhite skipempty
syntax region asemeComment_595 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_593,asemeComment_595 skipwhite skipempty
syntax match asemeComment_595 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_593,asemeComment_595 skipwhite skipempty
syntax match asemeReference_593 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_586,asemeComment_588 skipwhite skipempty
syntax match asemeClause_591 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_589,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_589,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_589,asemeComment_592 skipwhite skipempty
syntax match asemeReference_589 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_587,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_587,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_587,asemeComment_590 skipwhite skipempty
syntax match asemeReference_587 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_586,asemeComment_588 skipwhite skipempty
syntax region asemeComment_588 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_586,asemeComment_588 skipwhite skipempty
syntax match asemeComment_588 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_586,asemeComment_588 skipwhite skipempty
syntax region asemePunctuation_586 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_585 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_552,asemeClause_555,asemeText_557,asemeNumber_558,asemeTruth_559,asemeLogic_560,asemeClause_561,asemeClause_562,asemeClause_563,asemeClause_564,asemeClause_565,asemeClause_566,asemeClause_567,asemeClause_568,asemeClause_569,asemeClause_570,asemeClause_571,asemeClause_572,asemeCall_573,asemeReference_574,asemeOperator_575,asemePunctuation_576
syntax match asemePunctuation_576 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeOperator_575 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeReference_574 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeCall_573 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_572 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_571 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_570 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_569 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_568 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_567 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_566 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_565 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_564 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_563 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_562 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_561 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeLogic_560 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeTruth_559 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeNumber_558 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeText_557 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%([.<>=!+*\/%,;)\]&\-]|\|\|))@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*%(<|>)|[^{}":?A-Za-z_])*%(\?%(\"%([^"\\\n]|\\.)*\"|[^{}"])*)?\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|[ \t]*[\r\n]\_s*%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[\-+*<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeClause_555 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax match asemeReference_554 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_547,asemeComment_549 skipwhite skipempty
syntax match asemeClause_552 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_550,asemeComment_553 skipwhite skipempty
syntax region asemeComment_553 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_550,asemeComment_553 skipwhite skipempty
syntax match asemeComment_553 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_550,asemeComment_553 skipwhite skipempty
syntax match asemeReference_550 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_548,asemeComment_551 skipwhite skipempty
syntax region asemeComment_551 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_548,asemeComment_551 skipwhite skipempty
syntax match asemeComment_551 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_548,asemeComment_551 skipwhite skipempty
syntax match asemeReference_548 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_547,asemeComment_549 skipwhite skipempty
syntax region asemeComment_549 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_547,asemeComment_549 skipwhite skipempty
syntax match asemeComment_549 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_547,asemeComment_549 skipwhite skipempty
syntax region asemePunctuation_547 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax region asemeComment_546 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax match asemeComment_546 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_546 skipwhite skipempty
syntax cluster asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant contains=asemeText_481,asemeNumber_483,asemeReference_484,asemeNumber_485,asemeOperator_486,asemePunctuation_487
syntax match asemePunctuation_487 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemeOperator_486 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemeNumber_485 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemeReference_484 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemeNumber_483 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemeText_481 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>)|%(given|result)\_s+\w+\_s*\:|plays\_s+\w+\_s*\.))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax region asemeComment_482 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax match asemeComment_482 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessTokenBeforeAsemeProcessInBodyOfParticipant,@asemeProcessInBodyOfParticipant,asemeComment_482 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant contains=asemeClause_387,asemeClause_390,asemeText_392,asemeNumber_393,asemeTruth_394,asemeLogic_395,asemeClause_396,asemeClause_397,asemeClause_398,asemeClause_399,asemeClause_400,asemeClause_401,asemeClause_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeClause_406,asemeClause_407,asemeCall_408,asemeReference_409,asemeOperator_410,asemePunctuation_411
syntax match asemePunctuation_411 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeOperator_410 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeReference_409 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeCall_408 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_407 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_406 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_402 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_401 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_400 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_399 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_398 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_397 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeClause_396 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeLogic_395 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeTruth_394 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeNumber_393 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeText_392 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
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
syntax region asemePunctuation_382 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax region asemeComment_381 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax match asemeComment_381 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeResultInBodyOfParticipant,@asemeResultInBodyOfParticipant,asemeComment_381 skipwhite skipempty
syntax cluster asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant contains=asemeClause_326,asemeClause_329,asemeText_331,asemeNumber_332,asemeTruth_333,asemeLogic_334,asemeClause_335,asemeClause_336,asemeClause_337,asemeClause_338,asemeClause_339,asemeClause_340,asemeClause_341,asemeClause_342,asemeClause_343,asemeClause_344,asemeClause_345,asemeClause_346,asemeCall_347,asemeReference_348,asemeOperator_349,asemePunctuation_350
syntax match asemePunctuation_350 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeOperator_349 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeReference_348 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeCall_347 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_346 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_345 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_344 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_343 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_342 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_341 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_340 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_339 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_338 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_337 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_336 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_335 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeLogic_334 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeTruth_333 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeNumber_332 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeText_331 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeClause_329 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_328,asemeComment_330 skipwhite skipempty
syntax region asemeComment_330 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_328,asemeComment_330 skipwhite skipempty
syntax match asemeComment_330 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_328,asemeComment_330 skipwhite skipempty
syntax match asemeReference_328 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_321,asemeComment_323 skipwhite skipempty
syntax match asemeClause_326 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_324,asemeComment_327 skipwhite skipempty
syntax region asemeComment_327 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_324,asemeComment_327 skipwhite skipempty
syntax match asemeComment_327 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_324,asemeComment_327 skipwhite skipempty
syntax match asemeReference_324 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_322,asemeComment_325 skipwhite skipempty
syntax region asemeComment_325 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_322,asemeComment_325 skipwhite skipempty
syntax match asemeComment_325 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_322,asemeComment_325 skipwhite skipempty
syntax match asemeReference_322 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_321,asemeComment_323 skipwhite skipempty
syntax region asemeComment_323 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_321,asemeComment_323 skipwhite skipempty
syntax match asemeComment_323 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_321,asemeComment_323 skipwhite skipempty
syntax region asemePunctuation_321 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax region asemeComment_320 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax match asemeComment_320 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionTokenBeforeAsemeVarInBodyOfParticipant,@asemeVarInBodyOfParticipant,asemeComment_320 skipwhite skipempty
syntax cluster asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant contains=asemeClause_257,asemeClause_260,asemeText_262,asemeNumber_263,asemeTruth_264,asemeLogic_265,asemeClause_266,asemeClause_267,asemeClause_268,asemeClause_269,asemeClause_270,asemeClause_271,asemeClause_272,asemeClause_273,asemeClause_274,asemeClause_275,asemeClause_276,asemeClause_277,asemeCall_278,asemeReference_279,asemeOperator_280,asemePunctuation_281
syntax match asemePunctuation_281 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeOperator_280 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[\-+*<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeReference_279 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeCall_278 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_277 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_276 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_275 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_274 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_273 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=one%(<|>)%(\_s+%(%(and|or|except)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_272 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=reply_by%(<|>)%(\_s+[0-9A-Za-z_(])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_271 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_270 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_269 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_268 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_267 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeClause_266 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeLogic_265 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeTruth_264 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeNumber_263 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeText_262 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(given|result)\_s+\w+\_s*\:|%(state|language|on|exit)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|\,%(%([^(){}"]*%(\([^(){}]*%(\([^(){}]*\)[^(){}]*)*\)[^(){}"]*)*\)|[^\[\]{}]*\]))@=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeBindingTokenBeforeAsemePlaysInBodyOfParticipant,@asemePlaysInBodyOfParticipant,asemeComment_251 skipwhite skipempty
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
highlight default link asemeBlock_105 asemeBlock
highlight default link asemeBlock_107 asemeBlock
highlight default link asemeBlock_1109 asemeBlock
highlight default link asemeBlock_1111 asemeBlock
highlight default link asemeBlock_1178 asemeBlock
highlight default link asemeBlock_1180 asemeBlock
highlight default link asemeBlock_136 asemeBlock
highlight default link asemeBlock_137 asemeBlock
highlight default link asemeBlock_199 asemeBlock
highlight default link asemeBlock_201 asemeBlock
highlight default link asemeBlock_491 asemeBlock
highlight default link asemeBlock_492 asemeBlock
highlight default link asemeBlock_629 asemeBlock
highlight default link asemeBlock_635 asemeBlock
highlight default link asemeBlock_640 asemeBlock
highlight default link asemeBlock_642 asemeBlock
highlight default link asemeBlock_645 asemeBlock
highlight default link asemeBlock_79 asemeBlock
highlight default link asemeBlock_81 asemeBlock
highlight default link asemeBlock_945 asemeBlock
highlight default link asemeBlock_947 asemeBlock
highlight default link asemeBlock_959 asemeBlock
highlight default link asemeBlock_965 asemeBlock
highlight default link asemeBlock_970 asemeBlock
highlight default link asemeBlock_971 asemeBlock
highlight default link asemeBlock_976 asemeBlock
highlight default link asemeBuiltIn_101 asemeBuiltIn
highlight default link asemeBuiltIn_1046 asemeBuiltIn
highlight default link asemeBuiltIn_1083 asemeBuiltIn
highlight default link asemeBuiltIn_1089 asemeBuiltIn
highlight default link asemeBuiltIn_1091 asemeBuiltIn
highlight default link asemeBuiltIn_144 asemeBuiltIn
highlight default link asemeBuiltIn_154 asemeBuiltIn
highlight default link asemeBuiltIn_160 asemeBuiltIn
highlight default link asemeBuiltIn_170 asemeBuiltIn
highlight default link asemeBuiltIn_315 asemeBuiltIn
highlight default link asemeBuiltIn_352 asemeBuiltIn
highlight default link asemeBuiltIn_358 asemeBuiltIn
highlight default link asemeBuiltIn_360 asemeBuiltIn
highlight default link asemeBuiltIn_368 asemeBuiltIn
highlight default link asemeBuiltIn_376 asemeBuiltIn
highlight default link asemeBuiltIn_413 asemeBuiltIn
highlight default link asemeBuiltIn_419 asemeBuiltIn
highlight default link asemeBuiltIn_421 asemeBuiltIn
highlight default link asemeBuiltIn_473 asemeBuiltIn
highlight default link asemeBuiltIn_737 asemeBuiltIn
highlight default link asemeBuiltIn_774 asemeBuiltIn
highlight default link asemeBuiltIn_780 asemeBuiltIn
highlight default link asemeBuiltIn_782 asemeBuiltIn
highlight default link asemeBuiltIn_799 asemeBuiltIn
highlight default link asemeBuiltIn_856 asemeBuiltIn
highlight default link asemeBuiltIn_864 asemeBuiltIn
highlight default link asemeBuiltIn_878 asemeBuiltIn
highlight default link asemeBuiltIn_90 asemeBuiltIn
highlight default link asemeBuiltIn_95 asemeBuiltIn
highlight default link asemeCall_1037 asemeCall
highlight default link asemeCall_1078 asemeCall
highlight default link asemeCall_1141 asemeCall
highlight default link asemeCall_26 asemeCall
highlight default link asemeCall_278 asemeCall
highlight default link asemeCall_347 asemeCall
highlight default link asemeCall_408 asemeCall
highlight default link asemeCall_573 asemeCall
highlight default link asemeCall_612 asemeCall
highlight default link asemeCall_63 asemeCall
highlight default link asemeCall_684 asemeCall
highlight default link asemeCall_769 asemeCall
highlight default link asemeChoice_127 asemeChoice
highlight default link asemeChoice_207 asemeChoice
highlight default link asemeChoice_212 asemeChoice
highlight default link asemeChoice_498 asemeChoice
highlight default link asemeChoice_505 asemeChoice
highlight default link asemeChoice_821 asemeChoice
highlight default link asemeChoice_835 asemeChoice
highlight default link asemeChoice_842 asemeChoice
highlight default link asemeChoice_854 asemeChoice
highlight default link asemeChoice_855 asemeChoice
highlight default link asemeChoice_871 asemeChoice
highlight default link asemeChoice_890 asemeChoice
highlight default link asemeChoice_904 asemeChoice
highlight default link asemeChoice_911 asemeChoice
highlight default link asemeChoice_923 asemeChoice
highlight default link asemeChoice_924 asemeChoice
highlight default link asemeChoice_926 asemeChoice
highlight default link asemeChoice_985 asemeChoice
highlight default link asemeChoice_989 asemeChoice
highlight default link asemeChoice_997 asemeChoice
highlight default link asemeClause_1016 asemeClause
highlight default link asemeClause_1019 asemeClause
highlight default link asemeClause_1025 asemeClause
highlight default link asemeClause_1026 asemeClause
highlight default link asemeClause_1027 asemeClause
highlight default link asemeClause_1028 asemeClause
highlight default link asemeClause_1029 asemeClause
highlight default link asemeClause_1030 asemeClause
highlight default link asemeClause_1031 asemeClause
highlight default link asemeClause_1032 asemeClause
highlight default link asemeClause_1033 asemeClause
highlight default link asemeClause_1034 asemeClause
highlight default link asemeClause_1035 asemeClause
highlight default link asemeClause_1036 asemeClause
highlight default link asemeClause_1057 asemeClause
highlight default link asemeClause_1060 asemeClause
highlight default link asemeClause_1066 asemeClause
highlight default link asemeClause_1067 asemeClause
highlight default link asemeClause_1068 asemeClause
highlight default link asemeClause_1069 asemeClause
highlight default link asemeClause_1070 asemeClause
highlight default link asemeClause_1071 asemeClause
highlight default link asemeClause_1072 asemeClause
highlight default link asemeClause_1073 asemeClause
highlight default link asemeClause_1074 asemeClause
highlight default link asemeClause_1075 asemeClause
highlight default link asemeClause_1076 asemeClause
highlight default link asemeClause_1077 asemeClause
highlight default link asemeClause_112 asemeClause
highlight default link asemeClause_1120 asemeClause
highlight default link asemeClause_1123 asemeClause
highlight default link asemeClause_1129 asemeClause
highlight default link asemeClause_1130 asemeClause
highlight default link asemeClause_1131 asemeClause
highlight default link asemeClause_1132 asemeClause
highlight default link asemeClause_1133 asemeClause
highlight default link asemeClause_1134 asemeClause
highlight default link asemeClause_1135 asemeClause
highlight default link asemeClause_1136 asemeClause
highlight default link asemeClause_1137 asemeClause
highlight default link asemeClause_1138 asemeClause
highlight default link asemeClause_1139 asemeClause
highlight default link asemeClause_1140 asemeClause
highlight default link asemeClause_1148 asemeClause
highlight default link asemeClause_115 asemeClause
highlight default link asemeClause_118 asemeClause
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
highlight default link asemeClause_326 asemeClause
highlight default link asemeClause_329 asemeClause
highlight default link asemeClause_335 asemeClause
highlight default link asemeClause_336 asemeClause
highlight default link asemeClause_337 asemeClause
highlight default link asemeClause_338 asemeClause
highlight default link asemeClause_339 asemeClause
highlight default link asemeClause_340 asemeClause
highlight default link asemeClause_341 asemeClause
highlight default link asemeClause_342 asemeClause
highlight default link asemeClause_343 asemeClause
highlight default link asemeClause_344 asemeClause
highlight default link asemeClause_345 asemeClause
highlight default link asemeClause_346 asemeClause
highlight default link asemeClause_387 asemeClause
highlight default link asemeClause_390 asemeClause
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
highlight default link asemeClause_407 asemeClause
highlight default link asemeClause_42 asemeClause
highlight default link asemeClause_436 asemeClause
highlight default link asemeClause_439 asemeClause
highlight default link asemeClause_441 asemeClause
highlight default link asemeClause_45 asemeClause
highlight default link asemeClause_501 asemeClause
highlight default link asemeClause_503 asemeClause
highlight default link asemeClause_507 asemeClause
highlight default link asemeClause_51 asemeClause
highlight default link asemeClause_510 asemeClause
highlight default link asemeClause_512 asemeClause
highlight default link asemeClause_513 asemeClause
highlight default link asemeClause_516 asemeClause
highlight default link asemeClause_518 asemeClause
highlight default link asemeClause_519 asemeClause
highlight default link asemeClause_52 asemeClause
highlight default link asemeClause_520 asemeClause
highlight default link asemeClause_53 asemeClause
highlight default link asemeClause_54 asemeClause
highlight default link asemeClause_541 asemeClause
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_552 asemeClause
highlight default link asemeClause_555 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_561 asemeClause
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
highlight default link asemeClause_572 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_59 asemeClause
highlight default link asemeClause_591 asemeClause
highlight default link asemeClause_594 asemeClause
highlight default link asemeClause_60 asemeClause
highlight default link asemeClause_600 asemeClause
highlight default link asemeClause_601 asemeClause
highlight default link asemeClause_602 asemeClause
highlight default link asemeClause_603 asemeClause
highlight default link asemeClause_604 asemeClause
highlight default link asemeClause_605 asemeClause
highlight default link asemeClause_606 asemeClause
highlight default link asemeClause_607 asemeClause
highlight default link asemeClause_608 asemeClause
highlight default link asemeClause_609 asemeClause
highlight default link asemeClause_61 asemeClause
highlight default link asemeClause_610 asemeClause
highlight default link asemeClause_611 asemeClause
highlight default link asemeClause_62 asemeClause
highlight default link asemeClause_647 asemeClause
highlight default link asemeClause_663 asemeClause
highlight default link asemeClause_666 asemeClause
highlight default link asemeClause_672 asemeClause
highlight default link asemeClause_673 asemeClause
highlight default link asemeClause_674 asemeClause
highlight default link asemeClause_675 asemeClause
highlight default link asemeClause_676 asemeClause
highlight default link asemeClause_677 asemeClause
highlight default link asemeClause_678 asemeClause
highlight default link asemeClause_679 asemeClause
highlight default link asemeClause_680 asemeClause
highlight default link asemeClause_681 asemeClause
highlight default link asemeClause_682 asemeClause
highlight default link asemeClause_683 asemeClause
highlight default link asemeClause_691 asemeClause
highlight default link asemeClause_695 asemeClause
highlight default link asemeClause_748 asemeClause
highlight default link asemeClause_751 asemeClause
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
highlight default link asemeClause_768 asemeClause
highlight default link asemeClause_824 asemeClause
highlight default link asemeClause_827 asemeClause
highlight default link asemeClause_830 asemeClause
highlight default link asemeClause_833 asemeClause
highlight default link asemeClause_836 asemeClause
highlight default link asemeClause_839 asemeClause
highlight default link asemeClause_845 asemeClause
highlight default link asemeClause_848 asemeClause
highlight default link asemeClause_851 asemeClause
highlight default link asemeClause_853 asemeClause
highlight default link asemeClause_893 asemeClause
highlight default link asemeClause_896 asemeClause
highlight default link asemeClause_899 asemeClause
highlight default link asemeClause_902 asemeClause
highlight default link asemeClause_905 asemeClause
highlight default link asemeClause_908 asemeClause
highlight default link asemeClause_914 asemeClause
highlight default link asemeClause_917 asemeClause
highlight default link asemeClause_920 asemeClause
highlight default link asemeClause_922 asemeClause
highlight default link asemeClause_972 asemeClause
highlight default link asemeClause_981 asemeClause
highlight default link asemeComment_1000 asemeComment
highlight default link asemeComment_1002 asemeComment
highlight default link asemeComment_1005 asemeComment
highlight default link asemeComment_1007 asemeComment
highlight default link asemeComment_1009 asemeComment
highlight default link asemeComment_1010 asemeComment
highlight default link asemeComment_1013 asemeComment
highlight default link asemeComment_1015 asemeComment
highlight default link asemeComment_1017 asemeComment
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_1020 asemeComment
highlight default link asemeComment_1043 asemeComment
highlight default link asemeComment_1045 asemeComment
highlight default link asemeComment_1047 asemeComment
highlight default link asemeComment_1050 asemeComment
highlight default link asemeComment_1051 asemeComment
highlight default link asemeComment_1054 asemeComment
highlight default link asemeComment_1056 asemeComment
highlight default link asemeComment_1058 asemeComment
highlight default link asemeComment_106 asemeComment
highlight default link asemeComment_1061 asemeComment
highlight default link asemeComment_1086 asemeComment
highlight default link asemeComment_1088 asemeComment
highlight default link asemeComment_109 asemeComment
highlight default link asemeComment_1094 asemeComment
highlight default link asemeComment_1096 asemeComment
highlight default link asemeComment_1098 asemeComment
highlight default link asemeComment_1101 asemeComment
highlight default link asemeComment_1103 asemeComment
highlight default link asemeComment_1105 asemeComment
highlight default link asemeComment_1107 asemeComment
highlight default link asemeComment_111 asemeComment
highlight default link asemeComment_1110 asemeComment
highlight default link asemeComment_1113 asemeComment
highlight default link asemeComment_1114 asemeComment
highlight default link asemeComment_1117 asemeComment
highlight default link asemeComment_1119 asemeComment
highlight default link asemeComment_1121 asemeComment
highlight default link asemeComment_1124 asemeComment
highlight default link asemeComment_113 asemeComment
highlight default link asemeComment_1147 asemeComment
highlight default link asemeComment_1149 asemeComment
highlight default link asemeComment_1151 asemeComment
highlight default link asemeComment_1153 asemeComment
highlight default link asemeComment_1155 asemeComment
highlight default link asemeComment_1157 asemeComment
highlight default link asemeComment_1159 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_1162 asemeComment
highlight default link asemeComment_1164 asemeComment
highlight default link asemeComment_1167 asemeComment
highlight default link asemeComment_1170 asemeComment
highlight default link asemeComment_1173 asemeComment
highlight default link asemeComment_1179 asemeComment
highlight default link asemeComment_1182 asemeComment
highlight default link asemeComment_119 asemeComment
highlight default link asemeComment_1208 asemeComment
highlight default link asemeComment_121 asemeComment
highlight default link asemeComment_1211 asemeComment
highlight default link asemeComment_1219 asemeComment
highlight default link asemeComment_1222 asemeComment
highlight default link asemeComment_123 asemeComment
highlight default link asemeComment_126 asemeComment
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
highlight default link asemeComment_293 asemeComment
highlight default link asemeComment_296 asemeComment
highlight default link asemeComment_298 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_305 asemeComment
highlight default link asemeComment_307 asemeComment
highlight default link asemeComment_310 asemeComment
highlight default link asemeComment_312 asemeComment
highlight default link asemeComment_314 asemeComment
highlight default link asemeComment_316 asemeComment
highlight default link asemeComment_319 asemeComment
highlight default link asemeComment_320 asemeComment
highlight default link asemeComment_323 asemeComment
highlight default link asemeComment_325 asemeComment
highlight default link asemeComment_327 asemeComment
highlight default link asemeComment_330 asemeComment
highlight default link asemeComment_355 asemeComment
highlight default link asemeComment_357 asemeComment
highlight default link asemeComment_36 asemeComment
highlight default link asemeComment_363 asemeComment
highlight default link asemeComment_365 asemeComment
highlight default link asemeComment_367 asemeComment
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
highlight default link asemeComment_416 asemeComment
highlight default link asemeComment_418 asemeComment
highlight default link asemeComment_424 asemeComment
highlight default link asemeComment_426 asemeComment
highlight default link asemeComment_428 asemeComment
highlight default link asemeComment_43 asemeComment
highlight default link asemeComment_431 asemeComment
highlight default link asemeComment_433 asemeComment
highlight default link asemeComment_435 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_440 asemeComment
highlight default link asemeComment_444 asemeComment
highlight default link asemeComment_446 asemeComment
highlight default link asemeComment_449 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_454 asemeComment
highlight default link asemeComment_456 asemeComment
highlight default link asemeComment_458 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_460 asemeComment
highlight default link asemeComment_463 asemeComment
highlight default link asemeComment_466 asemeComment
highlight default link asemeComment_468 asemeComment
highlight default link asemeComment_470 asemeComment
highlight default link asemeComment_472 asemeComment
highlight default link asemeComment_476 asemeComment
highlight default link asemeComment_479 asemeComment
highlight default link asemeComment_482 asemeComment
highlight default link asemeComment_494 asemeComment
highlight default link asemeComment_497 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_502 asemeComment
highlight default link asemeComment_504 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_511 asemeComment
highlight default link asemeComment_514 asemeComment
highlight default link asemeComment_517 asemeComment
highlight default link asemeComment_523 asemeComment
highlight default link asemeComment_526 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_534 asemeComment
highlight default link asemeComment_536 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_540 asemeComment
highlight default link asemeComment_542 asemeComment
highlight default link asemeComment_545 asemeComment
highlight default link asemeComment_546 asemeComment
highlight default link asemeComment_549 asemeComment
highlight default link asemeComment_551 asemeComment
highlight default link asemeComment_553 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_588 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_595 asemeComment
highlight default link asemeComment_618 asemeComment
highlight default link asemeComment_620 asemeComment
highlight default link asemeComment_622 asemeComment
highlight default link asemeComment_627 asemeComment
highlight default link asemeComment_630 asemeComment
highlight default link asemeComment_633 asemeComment
highlight default link asemeComment_636 asemeComment
highlight default link asemeComment_638 asemeComment
highlight default link asemeComment_641 asemeComment
highlight default link asemeComment_644 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_648 asemeComment
highlight default link asemeComment_650 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_656 asemeComment
highlight default link asemeComment_657 asemeComment
highlight default link asemeComment_660 asemeComment
highlight default link asemeComment_662 asemeComment
highlight default link asemeComment_664 asemeComment
highlight default link asemeComment_667 asemeComment
highlight default link asemeComment_69 asemeComment
highlight default link asemeComment_690 asemeComment
highlight default link asemeComment_692 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_696 asemeComment
highlight default link asemeComment_699 asemeComment
highlight default link asemeComment_702 asemeComment
highlight default link asemeComment_704 asemeComment
highlight default link asemeComment_707 asemeComment
highlight default link asemeComment_71 asemeComment
highlight default link asemeComment_711 asemeComment
highlight default link asemeComment_713 asemeComment
highlight default link asemeComment_716 asemeComment
highlight default link asemeComment_718 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_722 asemeComment
highlight default link asemeComment_724 asemeComment
highlight default link asemeComment_727 asemeComment
highlight default link asemeComment_73 asemeComment
highlight default link asemeComment_731 asemeComment
highlight default link asemeComment_734 asemeComment
highlight default link asemeComment_736 asemeComment
highlight default link asemeComment_738 asemeComment
highlight default link asemeComment_741 asemeComment
highlight default link asemeComment_742 asemeComment
highlight default link asemeComment_745 asemeComment
highlight default link asemeComment_747 asemeComment
highlight default link asemeComment_749 asemeComment
highlight default link asemeComment_75 asemeComment
highlight default link asemeComment_752 asemeComment
highlight default link asemeComment_777 asemeComment
highlight default link asemeComment_779 asemeComment
highlight default link asemeComment_785 asemeComment
highlight default link asemeComment_787 asemeComment
highlight default link asemeComment_789 asemeComment
highlight default link asemeComment_792 asemeComment
highlight default link asemeComment_794 asemeComment
highlight default link asemeComment_796 asemeComment
highlight default link asemeComment_798 asemeComment
highlight default link asemeComment_80 asemeComment
highlight default link asemeComment_802 asemeComment
highlight default link asemeComment_805 asemeComment
highlight default link asemeComment_808 asemeComment
highlight default link asemeComment_818 asemeComment
highlight default link asemeComment_820 asemeComment
highlight default link asemeComment_822 asemeComment
highlight default link asemeComment_825 asemeComment
highlight default link asemeComment_828 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_831 asemeComment
highlight default link asemeComment_834 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_840 asemeComment
highlight default link asemeComment_843 asemeComment
highlight default link asemeComment_846 asemeComment
highlight default link asemeComment_849 asemeComment
highlight default link asemeComment_85 asemeComment
highlight default link asemeComment_852 asemeComment
highlight default link asemeComment_859 asemeComment
highlight default link asemeComment_861 asemeComment
highlight default link asemeComment_863 asemeComment
highlight default link asemeComment_867 asemeComment
highlight default link asemeComment_869 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_872 asemeComment
highlight default link asemeComment_877 asemeComment
highlight default link asemeComment_881 asemeComment
highlight default link asemeComment_887 asemeComment
highlight default link asemeComment_889 asemeComment
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
highlight default link asemeComment_915 asemeComment
highlight default link asemeComment_918 asemeComment
highlight default link asemeComment_921 asemeComment
highlight default link asemeComment_927 asemeComment
highlight default link asemeComment_932 asemeComment
highlight default link asemeComment_935 asemeComment
highlight default link asemeComment_940 asemeComment
highlight default link asemeComment_943 asemeComment
highlight default link asemeComment_946 asemeComment
highlight default link asemeComment_949 asemeComment
highlight default link asemeComment_951 asemeComment
highlight default link asemeComment_953 asemeComment
highlight default link asemeComment_957 asemeComment
highlight default link asemeComment_96 asemeComment
highlight default link asemeComment_960 asemeComment
highlight default link asemeComment_963 asemeComment
highlight default link asemeComment_966 asemeComment
highlight default link asemeComment_968 asemeComment
highlight default link asemeComment_973 asemeComment
highlight default link asemeComment_975 asemeComment
highlight default link asemeComment_978 asemeComment
highlight default link asemeComment_980 asemeComment
highlight default link asemeComment_982 asemeComment
highlight default link asemeComment_986 asemeComment
highlight default link asemeComment_99 asemeComment
highlight default link asemeComment_990 asemeComment
highlight default link asemeComment_992 asemeComment
highlight default link asemeComment_998 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_1001 asemeDeclaration
highlight default link asemeDeclaration_1044 asemeDeclaration
highlight default link asemeDeclaration_108 asemeDeclaration
highlight default link asemeDeclaration_1097 asemeDeclaration
highlight default link asemeDeclaration_1102 asemeDeclaration
highlight default link asemeDeclaration_1104 asemeDeclaration
highlight default link asemeDeclaration_1106 asemeDeclaration
highlight default link asemeDeclaration_1112 asemeDeclaration
highlight default link asemeDeclaration_1181 asemeDeclaration
highlight default link asemeDeclaration_1210 asemeDeclaration
highlight default link asemeDeclaration_1221 asemeDeclaration
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
highlight default link asemeDeclaration_313 asemeDeclaration
highlight default link asemeDeclaration_366 asemeDeclaration
highlight default link asemeDeclaration_374 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_427 asemeDeclaration
highlight default link asemeDeclaration_432 asemeDeclaration
highlight default link asemeDeclaration_453 asemeDeclaration
highlight default link asemeDeclaration_467 asemeDeclaration
highlight default link asemeDeclaration_493 asemeDeclaration
highlight default link asemeDeclaration_496 asemeDeclaration
highlight default link asemeDeclaration_529 asemeDeclaration
highlight default link asemeDeclaration_533 asemeDeclaration
highlight default link asemeDeclaration_584 asemeDeclaration
highlight default link asemeDeclaration_637 asemeDeclaration
highlight default link asemeDeclaration_643 asemeDeclaration
highlight default link asemeDeclaration_655 asemeDeclaration
highlight default link asemeDeclaration_70 asemeDeclaration
highlight default link asemeDeclaration_719 asemeDeclaration
highlight default link asemeDeclaration_735 asemeDeclaration
highlight default link asemeDeclaration_788 asemeDeclaration
highlight default link asemeDeclaration_793 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_817 asemeDeclaration
highlight default link asemeDeclaration_82 asemeDeclaration
highlight default link asemeDeclaration_886 asemeDeclaration
highlight default link asemeDeclaration_939 asemeDeclaration
highlight default link asemeDeclaration_942 asemeDeclaration
highlight default link asemeDeclaration_948 asemeDeclaration
highlight default link asemeDeclaration_967 asemeDeclaration
highlight default link asemeDeclaration_974 asemeDeclaration
highlight default link asemeDeclaration_977 asemeDeclaration
highlight default link asemeDeclaration_98 asemeDeclaration
highlight default link asemeLogic_1024 asemeLogic
highlight default link asemeLogic_1065 asemeLogic
highlight default link asemeLogic_1128 asemeLogic
highlight default link asemeLogic_13 asemeLogic
highlight default link asemeLogic_265 asemeLogic
highlight default link asemeLogic_334 asemeLogic
highlight default link asemeLogic_395 asemeLogic
highlight default link asemeLogic_50 asemeLogic
highlight default link asemeLogic_560 asemeLogic
highlight default link asemeLogic_599 asemeLogic
highlight default link asemeLogic_671 asemeLogic
highlight default link asemeLogic_756 asemeLogic
highlight default link asemeName_100 asemeName
highlight default link asemeName_1087 asemeName
highlight default link asemeName_1095 asemeName
highlight default link asemeName_1100 asemeName
highlight default link asemeName_1146 asemeName
highlight default link asemeName_1166 asemeName
highlight default link asemeName_1168 asemeName
highlight default link asemeName_1176 asemeName
highlight default link asemeName_159 asemeName
highlight default link asemeName_169 asemeName
highlight default link asemeName_174 asemeName
highlight default link asemeName_177 asemeName
highlight default link asemeName_194 asemeName
highlight default link asemeName_195 asemeName
highlight default link asemeName_233 asemeName
highlight default link asemeName_234 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_356 asemeName
highlight default link asemeName_364 asemeName
highlight default link asemeName_372 asemeName
highlight default link asemeName_417 asemeName
highlight default link asemeName_425 asemeName
highlight default link asemeName_430 asemeName
highlight default link asemeName_469 asemeName
highlight default link asemeName_477 asemeName
highlight default link asemeName_489 asemeName
highlight default link asemeName_509 asemeName
highlight default link asemeName_521 asemeName
highlight default link asemeName_528 asemeName
highlight default link asemeName_531 asemeName
highlight default link asemeName_68 asemeName
highlight default link asemeName_730 asemeName
highlight default link asemeName_733 asemeName
highlight default link asemeName_77 asemeName
highlight default link asemeName_778 asemeName
highlight default link asemeName_786 asemeName
highlight default link asemeName_791 asemeName
highlight default link asemeName_795 asemeName
highlight default link asemeName_803 asemeName
highlight default link asemeName_815 asemeName
highlight default link asemeName_860 asemeName
highlight default link asemeName_868 asemeName
highlight default link asemeName_884 asemeName
highlight default link asemeName_89 asemeName
highlight default link asemeName_93 asemeName
highlight default link asemeName_937 asemeName
highlight default link asemeName_94 asemeName
highlight default link asemeName_983 asemeName
highlight default link asemeName_987 asemeName
highlight default link asemeName_993 asemeName
highlight default link asemeName_995 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_1004 asemeNumber
highlight default link asemeNumber_1008 asemeNumber
highlight default link asemeNumber_1022 asemeNumber
highlight default link asemeNumber_1042 asemeNumber
highlight default link asemeNumber_1063 asemeNumber
highlight default link asemeNumber_11 asemeNumber
highlight default link asemeNumber_1126 asemeNumber
highlight default link asemeNumber_114 asemeNumber
highlight default link asemeNumber_1152 asemeNumber
highlight default link asemeNumber_1156 asemeNumber
highlight default link asemeNumber_1161 asemeNumber
highlight default link asemeNumber_117 asemeNumber
highlight default link asemeNumber_1184 asemeNumber
highlight default link asemeNumber_1190 asemeNumber
highlight default link asemeNumber_1196 asemeNumber
highlight default link asemeNumber_1202 asemeNumber
highlight default link asemeNumber_1213 asemeNumber
highlight default link asemeNumber_1225 asemeNumber
highlight default link asemeNumber_124 asemeNumber
highlight default link asemeNumber_240 asemeNumber
highlight default link asemeNumber_244 asemeNumber
highlight default link asemeNumber_263 asemeNumber
highlight default link asemeNumber_32 asemeNumber
highlight default link asemeNumber_332 asemeNumber
highlight default link asemeNumber_393 asemeNumber
highlight default link asemeNumber_48 asemeNumber
highlight default link asemeNumber_483 asemeNumber
highlight default link asemeNumber_485 asemeNumber
highlight default link asemeNumber_500 asemeNumber
highlight default link asemeNumber_506 asemeNumber
highlight default link asemeNumber_515 asemeNumber
highlight default link asemeNumber_539 asemeNumber
highlight default link asemeNumber_543 asemeNumber
highlight default link asemeNumber_558 asemeNumber
highlight default link asemeNumber_579 asemeNumber
highlight default link asemeNumber_581 asemeNumber
highlight default link asemeNumber_597 asemeNumber
highlight default link asemeNumber_617 asemeNumber
highlight default link asemeNumber_621 asemeNumber
highlight default link asemeNumber_669 asemeNumber
highlight default link asemeNumber_72 asemeNumber
highlight default link asemeNumber_754 asemeNumber
highlight default link asemeNumber_809 asemeNumber
highlight default link asemeNumber_811 asemeNumber
highlight default link asemeNumber_826 asemeNumber
highlight default link asemeNumber_829 asemeNumber
highlight default link asemeNumber_832 asemeNumber
highlight default link asemeNumber_84 asemeNumber
highlight default link asemeNumber_844 asemeNumber
highlight default link asemeNumber_895 asemeNumber
highlight default link asemeNumber_898 asemeNumber
highlight default link asemeNumber_901 asemeNumber
highlight default link asemeNumber_913 asemeNumber
highlight default link asemeNumber_991 asemeNumber
highlight default link asemeNumber_999 asemeNumber
highlight default link asemeOperator_1006 asemeOperator
highlight default link asemeOperator_1039 asemeOperator
highlight default link asemeOperator_1080 asemeOperator
highlight default link asemeOperator_1082 asemeOperator
highlight default link asemeOperator_1099 asemeOperator
highlight default link asemeOperator_1143 asemeOperator
highlight default link asemeOperator_1145 asemeOperator
highlight default link asemeOperator_1165 asemeOperator
highlight default link asemeOperator_1175 asemeOperator
highlight default link asemeOperator_1186 asemeOperator
highlight default link asemeOperator_1192 asemeOperator
highlight default link asemeOperator_1198 asemeOperator
highlight default link asemeOperator_1204 asemeOperator
highlight default link asemeOperator_1215 asemeOperator
highlight default link asemeOperator_142 asemeOperator
highlight default link asemeOperator_152 asemeOperator
highlight default link asemeOperator_166 asemeOperator
highlight default link asemeOperator_28 asemeOperator
highlight default link asemeOperator_280 asemeOperator
highlight default link asemeOperator_282 asemeOperator
highlight default link asemeOperator_294 asemeOperator
highlight default link asemeOperator_302 asemeOperator
highlight default link asemeOperator_349 asemeOperator
highlight default link asemeOperator_351 asemeOperator
highlight default link asemeOperator_410 asemeOperator
highlight default link asemeOperator_412 asemeOperator
highlight default link asemeOperator_429 asemeOperator
highlight default link asemeOperator_486 asemeOperator
highlight default link asemeOperator_488 asemeOperator
highlight default link asemeOperator_525 asemeOperator
highlight default link asemeOperator_530 asemeOperator
highlight default link asemeOperator_535 asemeOperator
highlight default link asemeOperator_537 asemeOperator
highlight default link asemeOperator_544 asemeOperator
highlight default link asemeOperator_575 asemeOperator
highlight default link asemeOperator_582 asemeOperator
highlight default link asemeOperator_614 asemeOperator
highlight default link asemeOperator_619 asemeOperator
highlight default link asemeOperator_624 asemeOperator
highlight default link asemeOperator_625 asemeOperator
highlight default link asemeOperator_626 asemeOperator
highlight default link asemeOperator_628 asemeOperator
highlight default link asemeOperator_631 asemeOperator
highlight default link asemeOperator_632 asemeOperator
highlight default link asemeOperator_634 asemeOperator
highlight default link asemeOperator_65 asemeOperator
highlight default link asemeOperator_67 asemeOperator
highlight default link asemeOperator_686 asemeOperator
highlight default link asemeOperator_688 asemeOperator
highlight default link asemeOperator_700 asemeOperator
highlight default link asemeOperator_708 asemeOperator
highlight default link asemeOperator_723 asemeOperator
highlight default link asemeOperator_74 asemeOperator
highlight default link asemeOperator_771 asemeOperator
highlight default link asemeOperator_773 asemeOperator
highlight default link asemeOperator_790 asemeOperator
highlight default link asemeOperator_812 asemeOperator
highlight default link asemeOperator_814 asemeOperator
highlight default link asemeOperator_86 asemeOperator
highlight default link asemeOperator_934 asemeOperator
highlight default link asemeOperator_950 asemeOperator
highlight default link asemeOperator_952 asemeOperator
highlight default link asemeOperator_954 asemeOperator
highlight default link asemeOperator_955 asemeOperator
highlight default link asemeOperator_956 asemeOperator
highlight default link asemeOperator_958 asemeOperator
highlight default link asemeOperator_961 asemeOperator
highlight default link asemeOperator_962 asemeOperator
highlight default link asemeOperator_964 asemeOperator
highlight default link asemePunctuation_1003 asemePunctuation
highlight default link asemePunctuation_1011 asemePunctuation
highlight default link asemePunctuation_104 asemePunctuation
highlight default link asemePunctuation_1040 asemePunctuation
highlight default link asemePunctuation_1041 asemePunctuation
highlight default link asemePunctuation_1049 asemePunctuation
highlight default link asemePunctuation_1052 asemePunctuation
highlight default link asemePunctuation_1081 asemePunctuation
highlight default link asemePunctuation_1085 asemePunctuation
highlight default link asemePunctuation_1093 asemePunctuation
highlight default link asemePunctuation_1108 asemePunctuation
highlight default link asemePunctuation_1115 asemePunctuation
highlight default link asemePunctuation_1144 asemePunctuation
highlight default link asemePunctuation_1150 asemePunctuation
highlight default link asemePunctuation_1154 asemePunctuation
highlight default link asemePunctuation_1158 asemePunctuation
highlight default link asemePunctuation_1160 asemePunctuation
highlight default link asemePunctuation_1163 asemePunctuation
highlight default link asemePunctuation_1169 asemePunctuation
highlight default link asemePunctuation_1172 asemePunctuation
highlight default link asemePunctuation_1174 asemePunctuation
highlight default link asemePunctuation_1177 asemePunctuation
highlight default link asemePunctuation_1187 asemePunctuation
highlight default link asemePunctuation_1188 asemePunctuation
highlight default link asemePunctuation_1193 asemePunctuation
highlight default link asemePunctuation_1194 asemePunctuation
highlight default link asemePunctuation_1199 asemePunctuation
highlight default link asemePunctuation_1200 asemePunctuation
highlight default link asemePunctuation_1205 asemePunctuation
highlight default link asemePunctuation_1206 asemePunctuation
highlight default link asemePunctuation_1216 asemePunctuation
highlight default link asemePunctuation_1217 asemePunctuation
highlight default link asemePunctuation_1228 asemePunctuation
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
highlight default link asemePunctuation_297 asemePunctuation
highlight default link asemePunctuation_300 asemePunctuation
highlight default link asemePunctuation_304 asemePunctuation
highlight default link asemePunctuation_309 asemePunctuation
highlight default link asemePunctuation_318 asemePunctuation
highlight default link asemePunctuation_321 asemePunctuation
highlight default link asemePunctuation_35 asemePunctuation
highlight default link asemePunctuation_350 asemePunctuation
highlight default link asemePunctuation_354 asemePunctuation
highlight default link asemePunctuation_362 asemePunctuation
highlight default link asemePunctuation_37 asemePunctuation
highlight default link asemePunctuation_370 asemePunctuation
highlight default link asemePunctuation_379 asemePunctuation
highlight default link asemePunctuation_382 asemePunctuation
highlight default link asemePunctuation_411 asemePunctuation
highlight default link asemePunctuation_415 asemePunctuation
highlight default link asemePunctuation_423 asemePunctuation
highlight default link asemePunctuation_445 asemePunctuation
highlight default link asemePunctuation_459 asemePunctuation
highlight default link asemePunctuation_471 asemePunctuation
highlight default link asemePunctuation_475 asemePunctuation
highlight default link asemePunctuation_478 asemePunctuation
highlight default link asemePunctuation_480 asemePunctuation
highlight default link asemePunctuation_487 asemePunctuation
highlight default link asemePunctuation_490 asemePunctuation
highlight default link asemePunctuation_522 asemePunctuation
highlight default link asemePunctuation_527 asemePunctuation
highlight default link asemePunctuation_547 asemePunctuation
highlight default link asemePunctuation_576 asemePunctuation
highlight default link asemePunctuation_577 asemePunctuation
highlight default link asemePunctuation_583 asemePunctuation
highlight default link asemePunctuation_586 asemePunctuation
highlight default link asemePunctuation_615 asemePunctuation
highlight default link asemePunctuation_616 asemePunctuation
highlight default link asemePunctuation_623 asemePunctuation
highlight default link asemePunctuation_639 asemePunctuation
highlight default link asemePunctuation_651 asemePunctuation
highlight default link asemePunctuation_658 asemePunctuation
highlight default link asemePunctuation_66 asemePunctuation
highlight default link asemePunctuation_687 asemePunctuation
highlight default link asemePunctuation_698 asemePunctuation
highlight default link asemePunctuation_703 asemePunctuation
highlight default link asemePunctuation_706 asemePunctuation
highlight default link asemePunctuation_710 asemePunctuation
highlight default link asemePunctuation_715 asemePunctuation
highlight default link asemePunctuation_726 asemePunctuation
highlight default link asemePunctuation_740 asemePunctuation
highlight default link asemePunctuation_743 asemePunctuation
highlight default link asemePunctuation_76 asemePunctuation
highlight default link asemePunctuation_772 asemePunctuation
highlight default link asemePunctuation_776 asemePunctuation
highlight default link asemePunctuation_78 asemePunctuation
highlight default link asemePunctuation_784 asemePunctuation
highlight default link asemePunctuation_797 asemePunctuation
highlight default link asemePunctuation_801 asemePunctuation
highlight default link asemePunctuation_804 asemePunctuation
highlight default link asemePunctuation_806 asemePunctuation
highlight default link asemePunctuation_813 asemePunctuation
highlight default link asemePunctuation_816 asemePunctuation
highlight default link asemePunctuation_858 asemePunctuation
highlight default link asemePunctuation_862 asemePunctuation
highlight default link asemePunctuation_866 asemePunctuation
highlight default link asemePunctuation_876 asemePunctuation
highlight default link asemePunctuation_88 asemePunctuation
highlight default link asemePunctuation_880 asemePunctuation
highlight default link asemePunctuation_882 asemePunctuation
highlight default link asemePunctuation_885 asemePunctuation
highlight default link asemePunctuation_931 asemePunctuation
highlight default link asemePunctuation_938 asemePunctuation
highlight default link asemePunctuation_944 asemePunctuation
highlight default link asemePunctuation_969 asemePunctuation
highlight default link asemeReference_1012 asemeReference
highlight default link asemeReference_1014 asemeReference
highlight default link asemeReference_1018 asemeReference
highlight default link asemeReference_1038 asemeReference
highlight default link asemeReference_1053 asemeReference
highlight default link asemeReference_1055 asemeReference
highlight default link asemeReference_1059 asemeReference
highlight default link asemeReference_1079 asemeReference
highlight default link asemeReference_110 asemeReference
highlight default link asemeReference_1116 asemeReference
highlight default link asemeReference_1118 asemeReference
highlight default link asemeReference_1122 asemeReference
highlight default link asemeReference_1142 asemeReference
highlight default link asemeReference_1171 asemeReference
highlight default link asemeReference_1185 asemeReference
highlight default link asemeReference_1191 asemeReference
highlight default link asemeReference_1197 asemeReference
highlight default link asemeReference_120 asemeReference
highlight default link asemeReference_1203 asemeReference
highlight default link asemeReference_1214 asemeReference
highlight default link asemeReference_1226 asemeReference
highlight default link asemeReference_1227 asemeReference
highlight default link asemeReference_128 asemeReference
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
highlight default link asemeReference_291 asemeReference
highlight default link asemeReference_295 asemeReference
highlight default link asemeReference_299 asemeReference
highlight default link asemeReference_303 asemeReference
highlight default link asemeReference_306 asemeReference
highlight default link asemeReference_308 asemeReference
highlight default link asemeReference_311 asemeReference
highlight default link asemeReference_322 asemeReference
highlight default link asemeReference_324 asemeReference
highlight default link asemeReference_328 asemeReference
highlight default link asemeReference_33 asemeReference
highlight default link asemeReference_34 asemeReference
highlight default link asemeReference_348 asemeReference
highlight default link asemeReference_38 asemeReference
highlight default link asemeReference_383 asemeReference
highlight default link asemeReference_385 asemeReference
highlight default link asemeReference_389 asemeReference
highlight default link asemeReference_40 asemeReference
highlight default link asemeReference_409 asemeReference
highlight default link asemeReference_434 asemeReference
highlight default link asemeReference_438 asemeReference
highlight default link asemeReference_44 asemeReference
highlight default link asemeReference_442 asemeReference
highlight default link asemeReference_443 asemeReference
highlight default link asemeReference_447 asemeReference
highlight default link asemeReference_448 asemeReference
highlight default link asemeReference_450 asemeReference
highlight default link asemeReference_451 asemeReference
highlight default link asemeReference_455 asemeReference
highlight default link asemeReference_457 asemeReference
highlight default link asemeReference_461 asemeReference
highlight default link asemeReference_462 asemeReference
highlight default link asemeReference_464 asemeReference
highlight default link asemeReference_465 asemeReference
highlight default link asemeReference_484 asemeReference
highlight default link asemeReference_524 asemeReference
highlight default link asemeReference_548 asemeReference
highlight default link asemeReference_550 asemeReference
highlight default link asemeReference_554 asemeReference
highlight default link asemeReference_574 asemeReference
highlight default link asemeReference_580 asemeReference
highlight default link asemeReference_587 asemeReference
highlight default link asemeReference_589 asemeReference
highlight default link asemeReference_593 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_613 asemeReference
highlight default link asemeReference_64 asemeReference
highlight default link asemeReference_649 asemeReference
highlight default link asemeReference_653 asemeReference
highlight default link asemeReference_654 asemeReference
highlight default link asemeReference_659 asemeReference
highlight default link asemeReference_661 asemeReference
highlight default link asemeReference_665 asemeReference
highlight default link asemeReference_685 asemeReference
highlight default link asemeReference_689 asemeReference
highlight default link asemeReference_693 asemeReference
highlight default link asemeReference_697 asemeReference
highlight default link asemeReference_701 asemeReference
highlight default link asemeReference_705 asemeReference
highlight default link asemeReference_709 asemeReference
highlight default link asemeReference_712 asemeReference
highlight default link asemeReference_714 asemeReference
highlight default link asemeReference_717 asemeReference
highlight default link asemeReference_721 asemeReference
highlight default link asemeReference_725 asemeReference
highlight default link asemeReference_744 asemeReference
highlight default link asemeReference_746 asemeReference
highlight default link asemeReference_750 asemeReference
highlight default link asemeReference_770 asemeReference
highlight default link asemeReference_810 asemeReference
highlight default link asemeReference_819 asemeReference
highlight default link asemeReference_823 asemeReference
highlight default link asemeReference_838 asemeReference
highlight default link asemeReference_841 asemeReference
highlight default link asemeReference_847 asemeReference
highlight default link asemeReference_850 asemeReference
highlight default link asemeReference_870 asemeReference
highlight default link asemeReference_873 asemeReference
highlight default link asemeReference_874 asemeReference
highlight default link asemeReference_875 asemeReference
highlight default link asemeReference_883 asemeReference
highlight default link asemeReference_888 asemeReference
highlight default link asemeReference_892 asemeReference
highlight default link asemeReference_907 asemeReference
highlight default link asemeReference_910 asemeReference
highlight default link asemeReference_916 asemeReference
highlight default link asemeReference_919 asemeReference
highlight default link asemeReference_925 asemeReference
highlight default link asemeReference_928 asemeReference
highlight default link asemeReference_929 asemeReference
highlight default link asemeReference_930 asemeReference
highlight default link asemeReference_936 asemeReference
highlight default link asemeReference_979 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_1021 asemeText
highlight default link asemeText_1062 asemeText
highlight default link asemeText_1125 asemeText
highlight default link asemeText_1183 asemeText
highlight default link asemeText_1189 asemeText
highlight default link asemeText_1195 asemeText
highlight default link asemeText_1201 asemeText
highlight default link asemeText_1207 asemeText
highlight default link asemeText_1209 asemeText
highlight default link asemeText_1212 asemeText
highlight default link asemeText_1218 asemeText
highlight default link asemeText_1220 asemeText
highlight default link asemeText_1223 asemeText
highlight default link asemeText_1224 asemeText
highlight default link asemeText_140 asemeText
highlight default link asemeText_151 asemeText
highlight default link asemeText_165 asemeText
highlight default link asemeText_193 asemeText
highlight default link asemeText_232 asemeText
highlight default link asemeText_248 asemeText
highlight default link asemeText_262 asemeText
highlight default link asemeText_30 asemeText
highlight default link asemeText_31 asemeText
highlight default link asemeText_331 asemeText
highlight default link asemeText_392 asemeText
highlight default link asemeText_47 asemeText
highlight default link asemeText_481 asemeText
highlight default link asemeText_495 asemeText
highlight default link asemeText_557 asemeText
highlight default link asemeText_578 asemeText
highlight default link asemeText_596 asemeText
highlight default link asemeText_668 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_728 asemeText
highlight default link asemeText_729 asemeText
highlight default link asemeText_732 asemeText
highlight default link asemeText_753 asemeText
highlight default link asemeText_807 asemeText
highlight default link asemeText_933 asemeText
highlight default link asemeText_941 asemeText
highlight default link asemeText_984 asemeText
highlight default link asemeText_988 asemeText
highlight default link asemeText_994 asemeText
highlight default link asemeText_996 asemeText
highlight default link asemeTruth_1023 asemeTruth
highlight default link asemeTruth_1064 asemeTruth
highlight default link asemeTruth_1127 asemeTruth
highlight default link asemeTruth_12 asemeTruth
highlight default link asemeTruth_264 asemeTruth
highlight default link asemeTruth_333 asemeTruth
highlight default link asemeTruth_394 asemeTruth
highlight default link asemeTruth_49 asemeTruth
highlight default link asemeTruth_559 asemeTruth
highlight default link asemeTruth_598 asemeTruth
highlight default link asemeTruth_670 asemeTruth
highlight default link asemeTruth_755 asemeTruth
highlight default link asemeType_103 asemeType
highlight default link asemeType_1048 asemeType
highlight default link asemeType_1084 asemeType
highlight default link asemeType_1090 asemeType
highlight default link asemeType_1092 asemeType
highlight default link asemeType_146 asemeType
highlight default link asemeType_156 asemeType
highlight default link asemeType_162 asemeType
highlight default link asemeType_172 asemeType
highlight default link asemeType_317 asemeType
highlight default link asemeType_353 asemeType
highlight default link asemeType_359 asemeType
highlight default link asemeType_361 asemeType
highlight default link asemeType_369 asemeType
highlight default link asemeType_378 asemeType
highlight default link asemeType_414 asemeType
highlight default link asemeType_420 asemeType
highlight default link asemeType_422 asemeType
highlight default link asemeType_474 asemeType
highlight default link asemeType_739 asemeType
highlight default link asemeType_775 asemeType
highlight default link asemeType_781 asemeType
highlight default link asemeType_783 asemeType
highlight default link asemeType_800 asemeType
highlight default link asemeType_857 asemeType
highlight default link asemeType_865 asemeType
highlight default link asemeType_879 asemeType
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
