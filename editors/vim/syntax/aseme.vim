" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
syntax sync fromstart
syntax match asemeReference_889 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_888 /\v\w+/
syntax match asemeNumber_887 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_886 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_885 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_890 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_885,asemeText_886,asemeNumber_887,asemeReference_888,asemeReference_889,asemePunctuation_890,asemeComment
syntax match asemeReference_32 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_31 /\v\w+/ contained
syntax match asemeNumber_30 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_29 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_28 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_33 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_66,asemeDeclaration_78,asemeDeclaration_104,asemeDeclaration_131,asemeDeclaration_161,asemeDeclaration_184,asemeDeclaration_216,asemeDeclaration_469,asemeDeclaration_712,asemeDeclaration_715,asemeDeclaration_783,asemeDeclaration_843,asemeDeclaration_872,asemeDeclaration_883,asemeText_885,asemeText_886,asemeNumber_887,asemeReference_888,asemeReference_889,asemePunctuation_890,asemeComment
syntax match asemeDeclaration_883 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_882,asemeComment_884 skipwhite skipempty
syntax region asemeComment_884 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_882,asemeComment_884 skipwhite skipempty
syntax match asemeComment_884 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_882,asemeComment_884 skipwhite skipempty
syntax match asemeText_882 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_881 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_879,asemeText_880
syntax match asemeText_880 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_881 skipwhite skipempty
syntax region asemeComment_881 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_881 skipwhite skipempty
syntax match asemeComment_881 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_881 skipwhite skipempty
syntax region asemePunctuation_879 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_862,asemeText_874,asemeNumber_875,asemeReference_876,asemeOperator_877,asemePunctuation_878,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_878 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_877 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_876 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_875 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_874 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_872 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_871,asemeComment_873 skipwhite skipempty
syntax region asemeComment_873 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_871,asemeComment_873 skipwhite skipempty
syntax match asemeComment_873 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_871,asemeComment_873 skipwhite skipempty
syntax match asemeText_871 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_870 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_868,asemeText_869
syntax match asemeText_869 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_870 skipwhite skipempty
syntax region asemeComment_870 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_870 skipwhite skipempty
syntax match asemeComment_870 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_870 skipwhite skipempty
syntax region asemePunctuation_868 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_862,asemeText_863,asemeNumber_864,asemeReference_865,asemeOperator_866,asemePunctuation_867,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_867 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_866 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_865 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_864 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_863 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_862 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_856,asemeText_857,asemeNumber_858,asemeReference_859,asemeOperator_860,asemePunctuation_861,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_861 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_860 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_859 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_858 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_857 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_856 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_850,asemeText_851,asemeNumber_852,asemeReference_853,asemeOperator_854,asemePunctuation_855,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_855 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_854 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_853 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_852 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_851 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_850 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_845,asemeNumber_846,asemeReference_847,asemeOperator_848,asemePunctuation_849,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemePunctuation_849 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_848 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_847 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_846 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_845 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_843 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_842,asemeComment_844 skipwhite skipempty
syntax region asemeComment_844 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_842,asemeComment_844 skipwhite skipempty
syntax match asemeComment_844 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_842,asemeComment_844 skipwhite skipempty
syntax match asemeBlock_842 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_841 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_839,asemeBlock_840
syntax match asemeBlock_840 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_841 skipwhite skipempty
syntax region asemeComment_841 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_841 skipwhite skipempty
syntax match asemeComment_841 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_841 skipwhite skipempty
syntax region asemePunctuation_839 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_838,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_838 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_820 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemeClause_817,asemePunctuation_827,asemePunctuation_833,asemePunctuation_836
syntax match asemePunctuation_836 /\v\:/ contained nextgroup=asemeReference_835,asemeComment_837 skipwhite skipempty
syntax region asemeComment_837 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_835,asemeComment_837 skipwhite skipempty
syntax match asemeComment_837 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_835,asemeComment_837 skipwhite skipempty
syntax match asemeReference_835 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_820 skipwhite skipempty
syntax match asemePunctuation_833 /\v\,/ contained nextgroup=asemeName_830,asemeName_832,asemeComment_834 skipwhite skipempty
syntax region asemeComment_834 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_830,asemeName_832,asemeComment_834 skipwhite skipempty
syntax match asemeComment_834 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_830,asemeName_832,asemeComment_834 skipwhite skipempty
syntax match asemeName_832 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_820 skipwhite skipempty
syntax match asemeName_830 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_829,asemeComment_831 skipwhite skipempty
syntax region asemeComment_831 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_829,asemeComment_831 skipwhite skipempty
syntax match asemeComment_831 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_829,asemeComment_831 skipwhite skipempty
syntax match asemeOperator_829 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemePunctuation_827 /\v\[/ contained nextgroup=asemeNumber_825,asemeComment_828 skipwhite skipempty
syntax region asemeComment_828 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_825,asemeComment_828 skipwhite skipempty
syntax match asemeComment_828 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_825,asemeComment_828 skipwhite skipempty
syntax match asemeNumber_825 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_823,asemeComment_826 skipwhite skipempty
syntax region asemeComment_826 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_823,asemeComment_826 skipwhite skipempty
syntax match asemeComment_826 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_823,asemeComment_826 skipwhite skipempty
syntax match asemePunctuation_823 /\v\.\./ contained nextgroup=asemeNumber_821,asemeComment_824 skipwhite skipempty
syntax region asemeComment_824 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_821,asemeComment_824 skipwhite skipempty
syntax match asemeComment_824 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_821,asemeComment_824 skipwhite skipempty
syntax match asemeNumber_821 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_819,asemeComment_822 skipwhite skipempty
syntax region asemeComment_822 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_819,asemeComment_822 skipwhite skipempty
syntax match asemeComment_822 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_819,asemeComment_822 skipwhite skipempty
syntax match asemePunctuation_819 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_820 skipwhite skipempty
syntax region asemeComment_820 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_820 skipwhite skipempty
syntax match asemeComment_820 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_820 skipwhite skipempty
syntax match asemeClause_817 /\vwith%(<|>)/ contained nextgroup=asemeName_815,asemeComment_818 skipwhite skipempty
syntax region asemeComment_818 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_815,asemeComment_818 skipwhite skipempty
syntax match asemeComment_818 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_815,asemeComment_818 skipwhite skipempty
syntax match asemeName_815 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_814,asemeComment_816 skipwhite skipempty
syntax region asemeComment_816 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_814,asemeComment_816 skipwhite skipempty
syntax match asemeComment_816 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_814,asemeComment_816 skipwhite skipempty
syntax match asemeOperator_814 /\v\=%(\=)@!/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax cluster asemeSettingToken contains=asemeClause_791,asemeClause_794,asemeText_796,asemeNumber_797,asemeTruth_798,asemeLogic_799,asemeClause_800,asemeClause_801,asemeClause_802,asemeClause_803,asemeClause_804,asemeClause_805,asemeClause_806,asemeClause_807,asemeClause_808,asemeClause_809,asemeCall_810,asemeReference_811,asemeOperator_812,asemePunctuation_813
syntax match asemePunctuation_813 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeOperator_812 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeReference_811 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeCall_810 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_809 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_808 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_807 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_806 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_805 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_804 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_803 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_802 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_801 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=when%(<|>)/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_800 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=else%(<|>)/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeLogic_799 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeTruth_798 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeNumber_797 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeText_796 /\v%(%(%([A-Za-z_][A-Za-z0-9_]*\_s*%([\[:]|\,\_s*[A-Za-z_][A-Za-z0-9_]*\_s*[\[:,]))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(\_s*\{)@!|\&\&|\|\||[<>=!]\=|[^ \t{}"0-9A-Za-z_:,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeClause_794 /\vwrite_messages%(<|>)%(%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)+\_s*\{)@=/ contained nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax region asemeComment_795 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax match asemeComment_795 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_793,asemeComment_795 skipwhite skipempty
syntax match asemeReference_793 /\v%(\.\_s*[A-Za-z_][A-Za-z0-9_]*\_s*)+%(\_s*\{)@=/ contained nextgroup=asemePunctuation_786,asemeComment_788 skipwhite skipempty
syntax match asemeClause_791 /\vsend%(<|>)%(\_s+[A-Za-z_][A-Za-z0-9_]*\_s+[A-Za-z_][A-Za-z0-9_]*\_s*\{)@=/ contained nextgroup=asemeReference_789,asemeComment_792 skipwhite skipempty
syntax region asemeComment_792 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_789,asemeComment_792 skipwhite skipempty
syntax match asemeComment_792 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_789,asemeComment_792 skipwhite skipempty
syntax match asemeReference_789 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*[A-Za-z_][A-Za-z0-9_]*)@=/ contained nextgroup=asemeReference_787,asemeComment_790 skipwhite skipempty
syntax region asemeComment_790 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_787,asemeComment_790 skipwhite skipempty
syntax match asemeComment_790 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_787,asemeComment_790 skipwhite skipempty
syntax match asemeReference_787 /\v[A-Za-z_][A-Za-z0-9_]*%(\_s*\{)@=/ contained nextgroup=asemePunctuation_786,asemeComment_788 skipwhite skipempty
syntax region asemeComment_788 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_786,asemeComment_788 skipwhite skipempty
syntax match asemeComment_788 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_786,asemeComment_788 skipwhite skipempty
syntax region asemePunctuation_786 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax region asemeComment_785 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeComment_785 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSettingToken,asemeComment_785 skipwhite skipempty
syntax match asemeDeclaration_783 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_782,asemeComment_784 skipwhite skipempty
syntax region asemeComment_784 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_782,asemeComment_784 skipwhite skipempty
syntax match asemeComment_784 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_782,asemeComment_784 skipwhite skipempty
syntax match asemeBlock_782 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_781 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_779,asemeBlock_780
syntax match asemeBlock_780 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_781 skipwhite skipempty
syntax region asemeComment_781 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_781 skipwhite skipempty
syntax match asemeComment_781 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_781 skipwhite skipempty
syntax region asemePunctuation_779 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_739,asemeNumber_746,asemeDeclaration_768,asemeDeclaration_773,asemeDeclaration_775,asemeDeclaration_777,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_777 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_778 skipwhite skipempty
syntax region asemeComment_778 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_778 skipwhite skipempty
syntax match asemeComment_778 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_778 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_685
syntax match asemeDeclaration_775 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax region asemeComment_776 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax match asemeComment_776 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_776 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_640
syntax match asemeDeclaration_773 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_771,asemeComment_774 skipwhite skipempty
syntax region asemeComment_774 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_771,asemeComment_774 skipwhite skipempty
syntax match asemeComment_774 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_771,asemeComment_774 skipwhite skipempty
syntax match asemeName_771 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_770,asemeComment_772 skipwhite skipempty
syntax region asemeComment_772 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_770,asemeComment_772 skipwhite skipempty
syntax match asemeComment_772 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_770,asemeComment_772 skipwhite skipempty
syntax match asemeOperator_770 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_768 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_766,asemeComment_769 skipwhite skipempty
syntax region asemeComment_769 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_766,asemeComment_769 skipwhite skipempty
syntax match asemeComment_769 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_766,asemeComment_769 skipwhite skipempty
syntax match asemeName_766 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_764,asemeComment_767 skipwhite skipempty
syntax region asemeComment_767 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_764,asemeComment_767 skipwhite skipempty
syntax match asemeComment_767 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_764,asemeComment_767 skipwhite skipempty
syntax match asemePunctuation_764 /\v\:/ contained nextgroup=asemeBuiltIn_762,asemeType_763,asemeComment_765 skipwhite skipempty
syntax region asemeComment_765 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_762,asemeType_763,asemeComment_765 skipwhite skipempty
syntax match asemeComment_765 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_762,asemeType_763,asemeComment_765 skipwhite skipempty
syntax match asemeType_763 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeBuiltIn_762 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_751,asemeOperator_753,asemeName_758,asemeBuiltIn_760,asemeType_761
syntax match asemeType_761 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeBuiltIn_760 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeName_758 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_756,asemeComment_759 skipwhite skipempty
syntax region asemeComment_759 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_756,asemeComment_759 skipwhite skipempty
syntax match asemeComment_759 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_756,asemeComment_759 skipwhite skipempty
syntax match asemePunctuation_756 /\v\:/ contained nextgroup=asemeBuiltIn_754,asemeType_755,asemeComment_757 skipwhite skipempty
syntax region asemeComment_757 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_754,asemeType_755,asemeComment_757 skipwhite skipempty
syntax match asemeComment_757 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_754,asemeType_755,asemeComment_757 skipwhite skipempty
syntax match asemeType_755 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeBuiltIn_754 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeOperator_753 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemePunctuation_751 /\v\:/ contained nextgroup=asemeBuiltIn_748,asemeType_750,asemeComment_752 skipwhite skipempty
syntax region asemeComment_752 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_748,asemeType_750,asemeComment_752 skipwhite skipempty
syntax match asemeComment_752 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_748,asemeType_750,asemeComment_752 skipwhite skipempty
syntax match asemeType_750 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeBuiltIn_748 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax region asemeComment_749 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeComment_749 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_749 skipwhite skipempty
syntax match asemeNumber_746 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_744,asemeComment_747 skipwhite skipempty
syntax region asemeComment_747 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_744,asemeComment_747 skipwhite skipempty
syntax match asemeComment_747 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_744,asemeComment_747 skipwhite skipempty
syntax match asemeOperator_744 /\v\-\>/ contained nextgroup=asemeNumber_742,asemeComment_745 skipwhite skipempty
syntax region asemeComment_745 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_742,asemeComment_745 skipwhite skipempty
syntax match asemeComment_745 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_742,asemeComment_745 skipwhite skipempty
syntax match asemeNumber_742 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_741,asemeComment_743 skipwhite skipempty
syntax region asemeComment_743 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_741,asemeComment_743 skipwhite skipempty
syntax match asemeComment_743 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_741,asemeComment_743 skipwhite skipempty
syntax match asemePunctuation_741 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeDeclaration_739 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_737,asemeComment_740 skipwhite skipempty
syntax region asemeComment_740 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_737,asemeComment_740 skipwhite skipempty
syntax match asemeComment_740 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_737,asemeComment_740 skipwhite skipempty
syntax match asemeNumber_737 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_735,asemeComment_738 skipwhite skipempty
syntax region asemeComment_738 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_735,asemeComment_738 skipwhite skipempty
syntax match asemeComment_738 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_735,asemeComment_738 skipwhite skipempty
syntax match asemeChoice_735 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_733,asemeText_734,@asemeChartNodeInBodyOfStatechart,asemeComment_736 skipwhite skipempty
syntax region asemeComment_736 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_733,asemeText_734,@asemeChartNodeInBodyOfStatechart,asemeComment_736 skipwhite skipempty
syntax match asemeComment_736 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_733,asemeText_734,@asemeChartNodeInBodyOfStatechart,asemeComment_736 skipwhite skipempty
syntax match asemeText_734 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeName_733 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_719,asemeChoice_723,asemeNumber_729,asemeName_731,asemeText_732
syntax match asemeText_732 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeName_731 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeNumber_729 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_727,asemeComment_730 skipwhite skipempty
syntax region asemeComment_730 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_727,asemeComment_730 skipwhite skipempty
syntax match asemeComment_730 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_727,asemeComment_730 skipwhite skipempty
syntax match asemeChoice_727 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_725,asemeText_726,@asemeChartNodeInBodyOfStatechart,asemeComment_728 skipwhite skipempty
syntax region asemeComment_728 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_725,asemeText_726,@asemeChartNodeInBodyOfStatechart,asemeComment_728 skipwhite skipempty
syntax match asemeComment_728 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_725,asemeText_726,@asemeChartNodeInBodyOfStatechart,asemeComment_728 skipwhite skipempty
syntax match asemeText_726 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeName_725 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeChoice_723 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_721,asemeText_722,@asemeChartNodeInBodyOfStatechart,asemeComment_724 skipwhite skipempty
syntax region asemeComment_724 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_721,asemeText_722,@asemeChartNodeInBodyOfStatechart,asemeComment_724 skipwhite skipempty
syntax match asemeComment_724 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_721,asemeText_722,@asemeChartNodeInBodyOfStatechart,asemeComment_724 skipwhite skipempty
syntax match asemeText_722 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeName_721 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeClause_719 /\vactivity%(<|>)/ contained nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_717,asemeComment_720 skipwhite skipempty
syntax match asemeReference_717 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax region asemeComment_718 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeComment_718 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_718 skipwhite skipempty
syntax match asemeDeclaration_715 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_714,asemeComment_716 skipwhite skipempty
syntax region asemeComment_716 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_714,asemeComment_716 skipwhite skipempty
syntax match asemeComment_716 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_714,asemeComment_716 skipwhite skipempty
syntax match asemeBlock_714 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax match asemeDeclaration_712 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_710,asemeComment_713 skipwhite skipempty
syntax region asemeComment_713 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_710,asemeComment_713 skipwhite skipempty
syntax match asemeComment_713 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_710,asemeComment_713 skipwhite skipempty
syntax match asemeClause_710 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_709,asemeComment_711 skipwhite skipempty
syntax region asemeComment_711 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_709,asemeComment_711 skipwhite skipempty
syntax match asemeComment_711 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_709,asemeComment_711 skipwhite skipempty
syntax match asemeBlock_709 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_473,asemePunctuation_707,asemeBlock_708
syntax match asemeBlock_708 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_472 skipwhite skipempty
syntax region asemePunctuation_707 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_481,asemeDeclaration_517,asemeDeclaration_533,asemeDeclaration_555,asemeDeclaration_560,asemeDeclaration_584,asemeDeclaration_641,asemeDeclaration_686,asemeDeclaration_695,asemeDeclaration_705,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_705 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_703,asemeComment_706 skipwhite skipempty
syntax region asemeComment_706 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_703,asemeComment_706 skipwhite skipempty
syntax match asemeComment_706 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_703,asemeComment_706 skipwhite skipempty
syntax match asemeBlock_703 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_702,@asemeControlInBodyOfSrm,asemeComment_704 skipwhite skipempty
syntax region asemeComment_704 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_702,@asemeControlInBodyOfSrm,asemeComment_704 skipwhite skipempty
syntax match asemeComment_704 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_702,@asemeControlInBodyOfSrm,asemeComment_704 skipwhite skipempty
syntax match asemeOperator_702 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_698 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_454,asemeOperator_697,asemeBlock_700
syntax match asemeBlock_700 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_699,@asemeControlInBodyOfSrm,asemeComment_701 skipwhite skipempty
syntax region asemeComment_701 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_699,@asemeControlInBodyOfSrm,asemeComment_701 skipwhite skipempty
syntax match asemeComment_701 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_699,@asemeControlInBodyOfSrm,asemeComment_701 skipwhite skipempty
syntax match asemeOperator_699 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_698 skipwhite skipempty
syntax match asemeOperator_697 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_698 skipwhite skipempty
syntax region asemeComment_698 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_698 skipwhite skipempty
syntax match asemeComment_698 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_698 skipwhite skipempty
syntax match asemeDeclaration_695 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_694,asemeComment_696 skipwhite skipempty
syntax region asemeComment_696 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_694,asemeComment_696 skipwhite skipempty
syntax match asemeComment_696 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_694,asemeComment_696 skipwhite skipempty
syntax match asemeBlock_694 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_693 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_691,asemeBlock_692
syntax match asemeBlock_692 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_693 skipwhite skipempty
syntax region asemeComment_693 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_693 skipwhite skipempty
syntax match asemeComment_693 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_693 skipwhite skipempty
syntax region asemePunctuation_691 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_689,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeDeclaration_689 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_688,asemeComment_690 skipwhite skipempty
syntax region asemeComment_690 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_688,asemeComment_690 skipwhite skipempty
syntax match asemeComment_690 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_688,asemeComment_690 skipwhite skipempty
syntax match asemeText_688 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_686 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax region asemeComment_687 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax match asemeComment_687 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_687 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_685
syntax region asemePunctuation_685 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_684,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_684 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_648,asemeClause_651,asemeClause_654,asemeClause_657,asemeClause_660,asemeClause_663,asemeClause_666,asemeClause_669,asemeClause_672,asemePunctuation_679,asemeOperator_682
syntax match asemeOperator_682 /\v\=%(\=)@!/ contained nextgroup=asemeText_681,asemeComment_683 skipwhite skipempty
syntax region asemeComment_683 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_681,asemeComment_683 skipwhite skipempty
syntax match asemeComment_683 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_681,asemeComment_683 skipwhite skipempty
syntax match asemeText_681 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemePunctuation_679 /\v\,/ contained nextgroup=asemeChoice_675,asemeReference_677,asemeReference_678,asemeComment_680 skipwhite skipempty
syntax region asemeComment_680 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_675,asemeReference_677,asemeReference_678,asemeComment_680 skipwhite skipempty
syntax match asemeComment_680 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_675,asemeReference_677,asemeReference_678,asemeComment_680 skipwhite skipempty
syntax match asemeReference_678 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeReference_677 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeChoice_675 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_674,asemeComment_676 skipwhite skipempty
syntax region asemeComment_676 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_674,asemeComment_676 skipwhite skipempty
syntax match asemeComment_676 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_674,asemeComment_676 skipwhite skipempty
syntax match asemeReference_674 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_672 /\vends%(<|>)/ contained nextgroup=asemeReference_671,asemeComment_673 skipwhite skipempty
syntax region asemeComment_673 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_671,asemeComment_673 skipwhite skipempty
syntax match asemeComment_673 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_671,asemeComment_673 skipwhite skipempty
syntax match asemeReference_671 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_669 /\vwrites%(<|>)/ contained nextgroup=asemeReference_668,asemeComment_670 skipwhite skipempty
syntax region asemeComment_670 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_668,asemeComment_670 skipwhite skipempty
syntax match asemeComment_670 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_668,asemeComment_670 skipwhite skipempty
syntax match asemeReference_668 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_666 /\vfor%(<|>)/ contained nextgroup=asemeNumber_665,asemeComment_667 skipwhite skipempty
syntax region asemeComment_667 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_665,asemeComment_667 skipwhite skipempty
syntax match asemeComment_667 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_665,asemeComment_667 skipwhite skipempty
syntax match asemeNumber_665 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_663 /\vuses%(<|>)/ contained nextgroup=asemeReference_662,asemeComment_664 skipwhite skipempty
syntax region asemeComment_664 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_662,asemeComment_664 skipwhite skipempty
syntax match asemeComment_664 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_662,asemeComment_664 skipwhite skipempty
syntax match asemeReference_662 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_660 /\vas%(<|>)/ contained nextgroup=asemeChoice_659,asemeComment_661 skipwhite skipempty
syntax region asemeComment_661 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_659,asemeComment_661 skipwhite skipempty
syntax match asemeComment_661 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_659,asemeComment_661 skipwhite skipempty
syntax match asemeChoice_659 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_657 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_656,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_656,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_656,asemeComment_658 skipwhite skipempty
syntax match asemeNumber_656 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_654 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_653,asemeComment_655 skipwhite skipempty
syntax region asemeComment_655 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_653,asemeComment_655 skipwhite skipempty
syntax match asemeComment_655 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_653,asemeComment_655 skipwhite skipempty
syntax match asemeNumber_653 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_651 /\vevery%(<|>)/ contained nextgroup=asemeNumber_650,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_650,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_650,asemeComment_652 skipwhite skipempty
syntax match asemeNumber_650 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeClause_648 /\vreads%(<|>)/ contained nextgroup=asemeChoice_645,asemeReference_647,asemeComment_649 skipwhite skipempty
syntax region asemeComment_649 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_645,asemeReference_647,asemeComment_649 skipwhite skipempty
syntax match asemeComment_649 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_645,asemeReference_647,asemeComment_649 skipwhite skipempty
syntax match asemeReference_647 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeChoice_645 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_643,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_643,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_643,asemeComment_646 skipwhite skipempty
syntax match asemeReference_643 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax region asemeComment_644 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeComment_644 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_644 skipwhite skipempty
syntax match asemeDeclaration_641 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_642 skipwhite skipempty
syntax region asemeComment_642 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_642 skipwhite skipempty
syntax match asemeComment_642 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_642 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_640
syntax region asemePunctuation_640 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_639,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_639 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_591,asemeClause_594,asemeClause_597,asemeClause_600,asemeClause_603,asemeClause_606,asemeClause_609,asemeClause_612,asemeClause_615,asemePunctuation_623,asemePunctuation_636,asemePunctuation_638
syntax match asemePunctuation_638 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemePunctuation_636 /\v\,/ contained nextgroup=asemeName_629,asemeChoice_632,asemeReference_634,asemeReference_635,asemeComment_637 skipwhite skipempty
syntax region asemeComment_637 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_629,asemeChoice_632,asemeReference_634,asemeReference_635,asemeComment_637 skipwhite skipempty
syntax match asemeComment_637 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_629,asemeChoice_632,asemeReference_634,asemeReference_635,asemeComment_637 skipwhite skipempty
syntax match asemeReference_635 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeReference_634 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeChoice_632 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_631,asemeComment_633 skipwhite skipempty
syntax region asemeComment_633 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_631,asemeComment_633 skipwhite skipempty
syntax match asemeComment_633 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_631,asemeComment_633 skipwhite skipempty
syntax match asemeReference_631 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeName_629 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_627,asemeComment_630 skipwhite skipempty
syntax region asemeComment_630 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_627,asemeComment_630 skipwhite skipempty
syntax match asemeComment_630 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_627,asemeComment_630 skipwhite skipempty
syntax match asemePunctuation_627 /\v\:/ contained nextgroup=asemeBuiltIn_625,asemeType_626,asemeComment_628 skipwhite skipempty
syntax region asemeComment_628 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_625,asemeType_626,asemeComment_628 skipwhite skipempty
syntax match asemeComment_628 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_625,asemeType_626,asemeComment_628 skipwhite skipempty
syntax match asemeType_626 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeBuiltIn_625 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemePunctuation_623 /\v\(/ contained nextgroup=asemeName_621,asemeComment_624 skipwhite skipempty
syntax region asemeComment_624 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_621,asemeComment_624 skipwhite skipempty
syntax match asemeComment_624 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_621,asemeComment_624 skipwhite skipempty
syntax match asemeName_621 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_619,asemeComment_622 skipwhite skipempty
syntax region asemeComment_622 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_619,asemeComment_622 skipwhite skipempty
syntax match asemeComment_622 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_619,asemeComment_622 skipwhite skipempty
syntax match asemePunctuation_619 /\v\:/ contained nextgroup=asemeBuiltIn_617,asemeType_618,asemeComment_620 skipwhite skipempty
syntax region asemeComment_620 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_617,asemeType_618,asemeComment_620 skipwhite skipempty
syntax match asemeComment_620 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_617,asemeType_618,asemeComment_620 skipwhite skipempty
syntax match asemeType_618 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeBuiltIn_617 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_615 /\vends%(<|>)/ contained nextgroup=asemeReference_614,asemeComment_616 skipwhite skipempty
syntax region asemeComment_616 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_614,asemeComment_616 skipwhite skipempty
syntax match asemeComment_616 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_614,asemeComment_616 skipwhite skipempty
syntax match asemeReference_614 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_612 /\vwrites%(<|>)/ contained nextgroup=asemeReference_611,asemeComment_613 skipwhite skipempty
syntax region asemeComment_613 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_611,asemeComment_613 skipwhite skipempty
syntax match asemeComment_613 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_611,asemeComment_613 skipwhite skipempty
syntax match asemeReference_611 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_609 /\vfor%(<|>)/ contained nextgroup=asemeNumber_608,asemeComment_610 skipwhite skipempty
syntax region asemeComment_610 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_608,asemeComment_610 skipwhite skipempty
syntax match asemeComment_610 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_608,asemeComment_610 skipwhite skipempty
syntax match asemeNumber_608 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_606 /\vuses%(<|>)/ contained nextgroup=asemeReference_605,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_605,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_605,asemeComment_607 skipwhite skipempty
syntax match asemeReference_605 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_603 /\vas%(<|>)/ contained nextgroup=asemeChoice_602,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_602,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_602,asemeComment_604 skipwhite skipempty
syntax match asemeChoice_602 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_600 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax match asemeNumber_599 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_597 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_596,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_596,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_596,asemeComment_598 skipwhite skipempty
syntax match asemeNumber_596 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_594 /\vevery%(<|>)/ contained nextgroup=asemeNumber_593,asemeComment_595 skipwhite skipempty
syntax region asemeComment_595 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_593,asemeComment_595 skipwhite skipempty
syntax match asemeComment_595 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_593,asemeComment_595 skipwhite skipempty
syntax match asemeNumber_593 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeClause_591 /\vreads%(<|>)/ contained nextgroup=asemeChoice_588,asemeReference_590,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_588,asemeReference_590,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_588,asemeReference_590,asemeComment_592 skipwhite skipempty
syntax match asemeReference_590 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeChoice_588 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_586,asemeComment_589 skipwhite skipempty
syntax region asemeComment_589 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_586,asemeComment_589 skipwhite skipempty
syntax match asemeComment_589 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_586,asemeComment_589 skipwhite skipempty
syntax match asemeReference_586 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax region asemeComment_587 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeComment_587 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_587 skipwhite skipempty
syntax match asemeDeclaration_584 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_583
syntax region asemePunctuation_583 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_582,asemeText_28,asemeText_29,asemeNumber_30,asemeReference_31,asemeReference_32,asemePunctuation_33,asemeComment
syntax match asemeName_582 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_564,asemePunctuation_568,asemePunctuation_571,asemePunctuation_573,asemeOperator_581
syntax match asemeOperator_581 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax cluster asemeFormulaToken contains=asemeText_574,asemeNumber_576,asemeReference_577,asemeNumber_578,asemeOperator_579,asemePunctuation_580
syntax match asemePunctuation_580 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemeOperator_579 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemeNumber_578 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemeReference_577 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemeNumber_576 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemeText_574 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax region asemeComment_575 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemeComment_575 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaToken,asemeComment_575 skipwhite skipempty
syntax match asemePunctuation_573 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax match asemePunctuation_571 /\v\,/ contained nextgroup=asemeName_570,asemeComment_572 skipwhite skipempty
syntax region asemeComment_572 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_570,asemeComment_572 skipwhite skipempty
syntax match asemeComment_572 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_570,asemeComment_572 skipwhite skipempty
syntax match asemeName_570 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax match asemePunctuation_568 /\v\:/ contained nextgroup=asemeBuiltIn_566,asemeType_567,asemeComment_569 skipwhite skipempty
syntax region asemeComment_569 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_566,asemeType_567,asemeComment_569 skipwhite skipempty
syntax match asemeComment_569 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_566,asemeType_567,asemeComment_569 skipwhite skipempty
syntax match asemeType_567 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax match asemeBuiltIn_566 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax match asemePunctuation_564 /\v\(/ contained nextgroup=asemeName_562,asemeComment_565 skipwhite skipempty
syntax region asemeComment_565 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_562,asemeComment_565 skipwhite skipempty
syntax match asemeComment_565 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_562,asemeComment_565 skipwhite skipempty
syntax match asemeName_562 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax region asemeComment_563 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax match asemeComment_563 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_563 skipwhite skipempty
syntax match asemeDeclaration_560 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_558,asemeComment_561 skipwhite skipempty
syntax region asemeComment_561 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_558,asemeComment_561 skipwhite skipempty
syntax match asemeComment_561 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_558,asemeComment_561 skipwhite skipempty
syntax match asemeName_558 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_557,asemeComment_559 skipwhite skipempty
syntax region asemeComment_559 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_557,asemeComment_559 skipwhite skipempty
syntax match asemeComment_559 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_557,asemeComment_559 skipwhite skipempty
syntax match asemeOperator_557 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeDeclaration_555 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_553,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_553,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_553,asemeComment_556 skipwhite skipempty
syntax match asemeName_553 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_551,asemeComment_554 skipwhite skipempty
syntax region asemeComment_554 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_551,asemeComment_554 skipwhite skipempty
syntax match asemeComment_554 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_551,asemeComment_554 skipwhite skipempty
syntax match asemePunctuation_551 /\v\:/ contained nextgroup=asemeBuiltIn_549,asemeType_550,asemeComment_552 skipwhite skipempty
syntax region asemeComment_552 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_549,asemeType_550,asemeComment_552 skipwhite skipempty
syntax match asemeComment_552 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_549,asemeType_550,asemeComment_552 skipwhite skipempty
syntax match asemeType_550 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_549 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_538,asemeOperator_540,asemeName_545,asemeBuiltIn_547,asemeType_548
syntax match asemeType_548 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_547 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeName_545 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_543,asemeComment_546 skipwhite skipempty
syntax region asemeComment_546 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_543,asemeComment_546 skipwhite skipempty
syntax match asemeComment_546 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_543,asemeComment_546 skipwhite skipempty
syntax match asemePunctuation_543 /\v\:/ contained nextgroup=asemeBuiltIn_541,asemeType_542,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_541,asemeType_542,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_541,asemeType_542,asemeComment_544 skipwhite skipempty
syntax match asemeType_542 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeBuiltIn_541 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_536 skipwhite skipempty
syntax match asemeOperator_540 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
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
syntax cluster asemeLabelledWay contains=asemeClause_424,asemeClause_427,asemeText_429,asemeNumber_430,asemeTruth_431,asemeLogic_432,asemeClause_433,asemeClause_434,asemeClause_435,asemeClause_436,asemeClause_437,asemeClause_438,asemeClause_439,asemeClause_440,asemeClause_441,asemeClause_442,asemeCall_443,asemeReference_444,asemeOperator_445,asemePunctuation_446
syntax match asemePunctuation_446 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeOperator_445 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeReference_444 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeCall_443 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_442 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_441 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_440 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_439 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_438 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_437 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_436 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_435 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_434 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeClause_433 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeLogic_432 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeTruth_431 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeNumber_430 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
syntax match asemeText_429 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_418 skipwhite skipempty
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
syntax match asemeDeclaration_417 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_376,asemeOperator_379,asemePunctuation_410,asemeText_411,asemeNumber_412,asemeReference_413,asemeNumber_414,asemeOperator_415,asemePunctuation_416
syntax match asemePunctuation_416 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeOperator_415 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeNumber_414 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeReference_413 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeNumber_412 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemeText_411 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_375 skipwhite skipempty
syntax match asemePunctuation_410 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeClause_387,asemeClause_390,asemeText_392,asemeNumber_393,asemeTruth_394,asemeLogic_395,asemeClause_396,asemeClause_397,asemeClause_398,asemeClause_399,asemeClause_400,asemeClause_401,asemeClause_402,asemeClause_403,asemeClause_404,asemeClause_405,asemeCall_406,asemeReference_407,asemeOperator_408,asemePunctuation_409
syntax match asemePunctuation_409 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeOperator_408 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeReference_407 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeCall_406 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_405 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_404 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_403 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_402 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_401 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_400 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_399 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_398 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_397 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeClause_396 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeLogic_395 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeTruth_394 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeNumber_393 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
syntax match asemeText_392 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_381 skipwhite skipempty
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
syntax match asemeOperator_332 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax cluster asemeProcessToken contains=asemeText_325,asemeNumber_327,asemeReference_328,asemeNumber_329,asemeOperator_330,asemePunctuation_331
syntax match asemePunctuation_331 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax match asemeOperator_330 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax match asemeNumber_329 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax match asemeReference_328 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax match asemeNumber_327 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax match asemeText_325 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax region asemeComment_326 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
syntax match asemeComment_326 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessToken,asemeComment_326 skipwhite skipempty
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
syntax match asemeOperator_263 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax cluster asemeExpressionToken contains=asemeClause_240,asemeClause_243,asemeText_245,asemeNumber_246,asemeTruth_247,asemeLogic_248,asemeClause_249,asemeClause_250,asemeClause_251,asemeClause_252,asemeClause_253,asemeClause_254,asemeClause_255,asemeClause_256,asemeClause_257,asemeClause_258,asemeCall_259,asemeReference_260,asemeOperator_261,asemePunctuation_262
syntax match asemePunctuation_262 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeOperator_261 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeReference_260 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeCall_259 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_258 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_257 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_256 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_255 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_254 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_253 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_252 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_251 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_250 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeClause_249 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeLogic_248 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeTruth_247 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeNumber_246 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeText_245 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
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
syntax region asemePunctuation_235 matchgroup=asemePunctuation start=/\v\{/ end=/}/ contained transparent contains=@asemeContentOfAMessage nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax region asemeComment_234 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
syntax match asemeComment_234 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_234 skipwhite skipempty
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
syntax cluster asemeLet contains=asemeClause_40,asemeClause_43,asemeText_45,asemeNumber_46,asemeTruth_47,asemeLogic_48,asemeClause_49,asemeClause_50,asemeClause_51,asemeClause_52,asemeClause_53,asemeClause_54,asemeClause_55,asemeClause_56,asemeClause_57,asemeClause_58,asemeCall_59,asemeReference_60,asemeOperator_61,asemePunctuation_62
syntax match asemePunctuation_62 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeOperator_61 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeReference_60 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeCall_59 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_58 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_57 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_56 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=lost%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_55 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=except%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_54 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_53 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_52 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_51 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_50 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeClause_49 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeLogic_48 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeTruth_47 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeNumber_46 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
syntax match asemeText_45 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_34 skipwhite skipempty
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
highlight default link asemeBlock_692 asemeBlock
highlight default link asemeBlock_694 asemeBlock
highlight default link asemeBlock_700 asemeBlock
highlight default link asemeBlock_703 asemeBlock
highlight default link asemeBlock_708 asemeBlock
highlight default link asemeBlock_709 asemeBlock
highlight default link asemeBlock_714 asemeBlock
highlight default link asemeBlock_75 asemeBlock
highlight default link asemeBlock_77 asemeBlock
highlight default link asemeBlock_780 asemeBlock
highlight default link asemeBlock_782 asemeBlock
highlight default link asemeBlock_840 asemeBlock
highlight default link asemeBlock_842 asemeBlock
highlight default link asemeBuiltIn_137 asemeBuiltIn
highlight default link asemeBuiltIn_145 asemeBuiltIn
highlight default link asemeBuiltIn_152 asemeBuiltIn
highlight default link asemeBuiltIn_229 asemeBuiltIn
highlight default link asemeBuiltIn_264 asemeBuiltIn
highlight default link asemeBuiltIn_270 asemeBuiltIn
highlight default link asemeBuiltIn_272 asemeBuiltIn
highlight default link asemeBuiltIn_317 asemeBuiltIn
highlight default link asemeBuiltIn_535 asemeBuiltIn
highlight default link asemeBuiltIn_541 asemeBuiltIn
highlight default link asemeBuiltIn_547 asemeBuiltIn
highlight default link asemeBuiltIn_549 asemeBuiltIn
highlight default link asemeBuiltIn_566 asemeBuiltIn
highlight default link asemeBuiltIn_617 asemeBuiltIn
highlight default link asemeBuiltIn_625 asemeBuiltIn
highlight default link asemeBuiltIn_748 asemeBuiltIn
highlight default link asemeBuiltIn_754 asemeBuiltIn
highlight default link asemeBuiltIn_760 asemeBuiltIn
highlight default link asemeBuiltIn_762 asemeBuiltIn
highlight default link asemeBuiltIn_86 asemeBuiltIn
highlight default link asemeBuiltIn_91 asemeBuiltIn
highlight default link asemeBuiltIn_97 asemeBuiltIn
highlight default link asemeCall_24 asemeCall
highlight default link asemeCall_259 asemeCall
highlight default link asemeCall_406 asemeCall
highlight default link asemeCall_443 asemeCall
highlight default link asemeCall_59 asemeCall
highlight default link asemeCall_810 asemeCall
highlight default link asemeChoice_120 asemeChoice
highlight default link asemeChoice_190 asemeChoice
highlight default link asemeChoice_342 asemeChoice
highlight default link asemeChoice_588 asemeChoice
highlight default link asemeChoice_602 asemeChoice
highlight default link asemeChoice_632 asemeChoice
highlight default link asemeChoice_645 asemeChoice
highlight default link asemeChoice_659 asemeChoice
highlight default link asemeChoice_675 asemeChoice
highlight default link asemeChoice_723 asemeChoice
highlight default link asemeChoice_727 asemeChoice
highlight default link asemeChoice_735 asemeChoice
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
highlight default link asemeClause_55 asemeClause
highlight default link asemeClause_56 asemeClause
highlight default link asemeClause_57 asemeClause
highlight default link asemeClause_58 asemeClause
highlight default link asemeClause_591 asemeClause
highlight default link asemeClause_594 asemeClause
highlight default link asemeClause_597 asemeClause
highlight default link asemeClause_600 asemeClause
highlight default link asemeClause_603 asemeClause
highlight default link asemeClause_606 asemeClause
highlight default link asemeClause_609 asemeClause
highlight default link asemeClause_612 asemeClause
highlight default link asemeClause_615 asemeClause
highlight default link asemeClause_648 asemeClause
highlight default link asemeClause_651 asemeClause
highlight default link asemeClause_654 asemeClause
highlight default link asemeClause_657 asemeClause
highlight default link asemeClause_660 asemeClause
highlight default link asemeClause_663 asemeClause
highlight default link asemeClause_666 asemeClause
highlight default link asemeClause_669 asemeClause
highlight default link asemeClause_672 asemeClause
highlight default link asemeClause_710 asemeClause
highlight default link asemeClause_719 asemeClause
highlight default link asemeClause_791 asemeClause
highlight default link asemeClause_794 asemeClause
highlight default link asemeClause_800 asemeClause
highlight default link asemeClause_801 asemeClause
highlight default link asemeClause_802 asemeClause
highlight default link asemeClause_803 asemeClause
highlight default link asemeClause_804 asemeClause
highlight default link asemeClause_805 asemeClause
highlight default link asemeClause_806 asemeClause
highlight default link asemeClause_807 asemeClause
highlight default link asemeClause_808 asemeClause
highlight default link asemeClause_809 asemeClause
highlight default link asemeClause_817 asemeClause
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
highlight default link asemeComment_544 asemeComment
highlight default link asemeComment_546 asemeComment
highlight default link asemeComment_552 asemeComment
highlight default link asemeComment_554 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_559 asemeComment
highlight default link asemeComment_561 asemeComment
highlight default link asemeComment_563 asemeComment
highlight default link asemeComment_565 asemeComment
highlight default link asemeComment_569 asemeComment
highlight default link asemeComment_572 asemeComment
highlight default link asemeComment_575 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_587 asemeComment
highlight default link asemeComment_589 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_595 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_610 asemeComment
highlight default link asemeComment_613 asemeComment
highlight default link asemeComment_616 asemeComment
highlight default link asemeComment_620 asemeComment
highlight default link asemeComment_622 asemeComment
highlight default link asemeComment_624 asemeComment
highlight default link asemeComment_628 asemeComment
highlight default link asemeComment_630 asemeComment
highlight default link asemeComment_633 asemeComment
highlight default link asemeComment_637 asemeComment
highlight default link asemeComment_642 asemeComment
highlight default link asemeComment_644 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_649 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_655 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_661 asemeComment
highlight default link asemeComment_664 asemeComment
highlight default link asemeComment_667 asemeComment
highlight default link asemeComment_67 asemeComment
highlight default link asemeComment_670 asemeComment
highlight default link asemeComment_673 asemeComment
highlight default link asemeComment_676 asemeComment
highlight default link asemeComment_680 asemeComment
highlight default link asemeComment_683 asemeComment
highlight default link asemeComment_687 asemeComment
highlight default link asemeComment_69 asemeComment
highlight default link asemeComment_690 asemeComment
highlight default link asemeComment_693 asemeComment
highlight default link asemeComment_696 asemeComment
highlight default link asemeComment_698 asemeComment
highlight default link asemeComment_701 asemeComment
highlight default link asemeComment_704 asemeComment
highlight default link asemeComment_706 asemeComment
highlight default link asemeComment_71 asemeComment
highlight default link asemeComment_711 asemeComment
highlight default link asemeComment_713 asemeComment
highlight default link asemeComment_716 asemeComment
highlight default link asemeComment_718 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_724 asemeComment
highlight default link asemeComment_728 asemeComment
highlight default link asemeComment_730 asemeComment
highlight default link asemeComment_736 asemeComment
highlight default link asemeComment_738 asemeComment
highlight default link asemeComment_740 asemeComment
highlight default link asemeComment_743 asemeComment
highlight default link asemeComment_745 asemeComment
highlight default link asemeComment_747 asemeComment
highlight default link asemeComment_749 asemeComment
highlight default link asemeComment_752 asemeComment
highlight default link asemeComment_757 asemeComment
highlight default link asemeComment_759 asemeComment
highlight default link asemeComment_76 asemeComment
highlight default link asemeComment_765 asemeComment
highlight default link asemeComment_767 asemeComment
highlight default link asemeComment_769 asemeComment
highlight default link asemeComment_772 asemeComment
highlight default link asemeComment_774 asemeComment
highlight default link asemeComment_776 asemeComment
highlight default link asemeComment_778 asemeComment
highlight default link asemeComment_781 asemeComment
highlight default link asemeComment_784 asemeComment
highlight default link asemeComment_785 asemeComment
highlight default link asemeComment_788 asemeComment
highlight default link asemeComment_79 asemeComment
highlight default link asemeComment_790 asemeComment
highlight default link asemeComment_792 asemeComment
highlight default link asemeComment_795 asemeComment
highlight default link asemeComment_81 asemeComment
highlight default link asemeComment_816 asemeComment
highlight default link asemeComment_818 asemeComment
highlight default link asemeComment_820 asemeComment
highlight default link asemeComment_822 asemeComment
highlight default link asemeComment_824 asemeComment
highlight default link asemeComment_826 asemeComment
highlight default link asemeComment_828 asemeComment
highlight default link asemeComment_83 asemeComment
highlight default link asemeComment_831 asemeComment
highlight default link asemeComment_834 asemeComment
highlight default link asemeComment_837 asemeComment
highlight default link asemeComment_841 asemeComment
highlight default link asemeComment_844 asemeComment
highlight default link asemeComment_87 asemeComment
highlight default link asemeComment_870 asemeComment
highlight default link asemeComment_873 asemeComment
highlight default link asemeComment_881 asemeComment
highlight default link asemeComment_884 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_92 asemeComment
highlight default link asemeComment_95 asemeComment
highlight default link asemeComment_98 asemeComment
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
highlight default link asemeDeclaration_555 asemeDeclaration
highlight default link asemeDeclaration_560 asemeDeclaration
highlight default link asemeDeclaration_584 asemeDeclaration
highlight default link asemeDeclaration_641 asemeDeclaration
highlight default link asemeDeclaration_66 asemeDeclaration
highlight default link asemeDeclaration_686 asemeDeclaration
highlight default link asemeDeclaration_689 asemeDeclaration
highlight default link asemeDeclaration_695 asemeDeclaration
highlight default link asemeDeclaration_705 asemeDeclaration
highlight default link asemeDeclaration_712 asemeDeclaration
highlight default link asemeDeclaration_715 asemeDeclaration
highlight default link asemeDeclaration_739 asemeDeclaration
highlight default link asemeDeclaration_768 asemeDeclaration
highlight default link asemeDeclaration_773 asemeDeclaration
highlight default link asemeDeclaration_775 asemeDeclaration
highlight default link asemeDeclaration_777 asemeDeclaration
highlight default link asemeDeclaration_78 asemeDeclaration
highlight default link asemeDeclaration_783 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_843 asemeDeclaration
highlight default link asemeDeclaration_872 asemeDeclaration
highlight default link asemeDeclaration_883 asemeDeclaration
highlight default link asemeDeclaration_94 asemeDeclaration
highlight default link asemeLogic_13 asemeLogic
highlight default link asemeLogic_248 asemeLogic
highlight default link asemeLogic_395 asemeLogic
highlight default link asemeLogic_432 asemeLogic
highlight default link asemeLogic_48 asemeLogic
highlight default link asemeLogic_799 asemeLogic
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
highlight default link asemeName_545 asemeName
highlight default link asemeName_553 asemeName
highlight default link asemeName_558 asemeName
highlight default link asemeName_562 asemeName
highlight default link asemeName_570 asemeName
highlight default link asemeName_582 asemeName
highlight default link asemeName_621 asemeName
highlight default link asemeName_629 asemeName
highlight default link asemeName_639 asemeName
highlight default link asemeName_64 asemeName
highlight default link asemeName_684 asemeName
highlight default link asemeName_721 asemeName
highlight default link asemeName_725 asemeName
highlight default link asemeName_73 asemeName
highlight default link asemeName_731 asemeName
highlight default link asemeName_733 asemeName
highlight default link asemeName_758 asemeName
highlight default link asemeName_766 asemeName
highlight default link asemeName_771 asemeName
highlight default link asemeName_815 asemeName
highlight default link asemeName_830 asemeName
highlight default link asemeName_832 asemeName
highlight default link asemeName_838 asemeName
highlight default link asemeName_85 asemeName
highlight default link asemeName_89 asemeName
highlight default link asemeName_90 asemeName
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
highlight default link asemeNumber_576 asemeNumber
highlight default link asemeNumber_578 asemeNumber
highlight default link asemeNumber_593 asemeNumber
highlight default link asemeNumber_596 asemeNumber
highlight default link asemeNumber_599 asemeNumber
highlight default link asemeNumber_608 asemeNumber
highlight default link asemeNumber_650 asemeNumber
highlight default link asemeNumber_653 asemeNumber
highlight default link asemeNumber_656 asemeNumber
highlight default link asemeNumber_665 asemeNumber
highlight default link asemeNumber_68 asemeNumber
highlight default link asemeNumber_729 asemeNumber
highlight default link asemeNumber_737 asemeNumber
highlight default link asemeNumber_742 asemeNumber
highlight default link asemeNumber_746 asemeNumber
highlight default link asemeNumber_797 asemeNumber
highlight default link asemeNumber_80 asemeNumber
highlight default link asemeNumber_821 asemeNumber
highlight default link asemeNumber_825 asemeNumber
highlight default link asemeNumber_846 asemeNumber
highlight default link asemeNumber_852 asemeNumber
highlight default link asemeNumber_858 asemeNumber
highlight default link asemeNumber_864 asemeNumber
highlight default link asemeNumber_875 asemeNumber
highlight default link asemeNumber_887 asemeNumber
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
highlight default link asemeOperator_540 asemeOperator
highlight default link asemeOperator_557 asemeOperator
highlight default link asemeOperator_579 asemeOperator
highlight default link asemeOperator_581 asemeOperator
highlight default link asemeOperator_61 asemeOperator
highlight default link asemeOperator_63 asemeOperator
highlight default link asemeOperator_682 asemeOperator
highlight default link asemeOperator_697 asemeOperator
highlight default link asemeOperator_699 asemeOperator
highlight default link asemeOperator_70 asemeOperator
highlight default link asemeOperator_702 asemeOperator
highlight default link asemeOperator_744 asemeOperator
highlight default link asemeOperator_753 asemeOperator
highlight default link asemeOperator_770 asemeOperator
highlight default link asemeOperator_812 asemeOperator
highlight default link asemeOperator_814 asemeOperator
highlight default link asemeOperator_82 asemeOperator
highlight default link asemeOperator_829 asemeOperator
highlight default link asemeOperator_848 asemeOperator
highlight default link asemeOperator_854 asemeOperator
highlight default link asemeOperator_860 asemeOperator
highlight default link asemeOperator_866 asemeOperator
highlight default link asemeOperator_877 asemeOperator
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
highlight default link asemePunctuation_543 asemePunctuation
highlight default link asemePunctuation_551 asemePunctuation
highlight default link asemePunctuation_564 asemePunctuation
highlight default link asemePunctuation_568 asemePunctuation
highlight default link asemePunctuation_571 asemePunctuation
highlight default link asemePunctuation_573 asemePunctuation
highlight default link asemePunctuation_580 asemePunctuation
highlight default link asemePunctuation_583 asemePunctuation
highlight default link asemePunctuation_619 asemePunctuation
highlight default link asemePunctuation_62 asemePunctuation
highlight default link asemePunctuation_623 asemePunctuation
highlight default link asemePunctuation_627 asemePunctuation
highlight default link asemePunctuation_636 asemePunctuation
highlight default link asemePunctuation_638 asemePunctuation
highlight default link asemePunctuation_640 asemePunctuation
highlight default link asemePunctuation_679 asemePunctuation
highlight default link asemePunctuation_685 asemePunctuation
highlight default link asemePunctuation_691 asemePunctuation
highlight default link asemePunctuation_707 asemePunctuation
highlight default link asemePunctuation_72 asemePunctuation
highlight default link asemePunctuation_74 asemePunctuation
highlight default link asemePunctuation_741 asemePunctuation
highlight default link asemePunctuation_751 asemePunctuation
highlight default link asemePunctuation_756 asemePunctuation
highlight default link asemePunctuation_764 asemePunctuation
highlight default link asemePunctuation_779 asemePunctuation
highlight default link asemePunctuation_786 asemePunctuation
highlight default link asemePunctuation_813 asemePunctuation
highlight default link asemePunctuation_819 asemePunctuation
highlight default link asemePunctuation_823 asemePunctuation
highlight default link asemePunctuation_827 asemePunctuation
highlight default link asemePunctuation_833 asemePunctuation
highlight default link asemePunctuation_836 asemePunctuation
highlight default link asemePunctuation_839 asemePunctuation
highlight default link asemePunctuation_84 asemePunctuation
highlight default link asemePunctuation_849 asemePunctuation
highlight default link asemePunctuation_850 asemePunctuation
highlight default link asemePunctuation_855 asemePunctuation
highlight default link asemePunctuation_856 asemePunctuation
highlight default link asemePunctuation_861 asemePunctuation
highlight default link asemePunctuation_862 asemePunctuation
highlight default link asemePunctuation_867 asemePunctuation
highlight default link asemePunctuation_868 asemePunctuation
highlight default link asemePunctuation_878 asemePunctuation
highlight default link asemePunctuation_879 asemePunctuation
highlight default link asemePunctuation_890 asemePunctuation
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
highlight default link asemeReference_577 asemeReference
highlight default link asemeReference_586 asemeReference
highlight default link asemeReference_590 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_60 asemeReference
highlight default link asemeReference_605 asemeReference
highlight default link asemeReference_611 asemeReference
highlight default link asemeReference_614 asemeReference
highlight default link asemeReference_631 asemeReference
highlight default link asemeReference_634 asemeReference
highlight default link asemeReference_635 asemeReference
highlight default link asemeReference_643 asemeReference
highlight default link asemeReference_647 asemeReference
highlight default link asemeReference_662 asemeReference
highlight default link asemeReference_668 asemeReference
highlight default link asemeReference_671 asemeReference
highlight default link asemeReference_674 asemeReference
highlight default link asemeReference_677 asemeReference
highlight default link asemeReference_678 asemeReference
highlight default link asemeReference_717 asemeReference
highlight default link asemeReference_787 asemeReference
highlight default link asemeReference_789 asemeReference
highlight default link asemeReference_793 asemeReference
highlight default link asemeReference_811 asemeReference
highlight default link asemeReference_835 asemeReference
highlight default link asemeReference_847 asemeReference
highlight default link asemeReference_853 asemeReference
highlight default link asemeReference_859 asemeReference
highlight default link asemeReference_865 asemeReference
highlight default link asemeReference_876 asemeReference
highlight default link asemeReference_888 asemeReference
highlight default link asemeReference_889 asemeReference
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
highlight default link asemeText_574 asemeText
highlight default link asemeText_681 asemeText
highlight default link asemeText_688 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_722 asemeText
highlight default link asemeText_726 asemeText
highlight default link asemeText_732 asemeText
highlight default link asemeText_734 asemeText
highlight default link asemeText_796 asemeText
highlight default link asemeText_845 asemeText
highlight default link asemeText_851 asemeText
highlight default link asemeText_857 asemeText
highlight default link asemeText_863 asemeText
highlight default link asemeText_869 asemeText
highlight default link asemeText_871 asemeText
highlight default link asemeText_874 asemeText
highlight default link asemeText_880 asemeText
highlight default link asemeText_882 asemeText
highlight default link asemeText_885 asemeText
highlight default link asemeText_886 asemeText
highlight default link asemeTruth_12 asemeTruth
highlight default link asemeTruth_247 asemeTruth
highlight default link asemeTruth_394 asemeTruth
highlight default link asemeTruth_431 asemeTruth
highlight default link asemeTruth_47 asemeTruth
highlight default link asemeTruth_798 asemeTruth
highlight default link asemeType_139 asemeType
highlight default link asemeType_147 asemeType
highlight default link asemeType_154 asemeType
highlight default link asemeType_231 asemeType
highlight default link asemeType_265 asemeType
highlight default link asemeType_271 asemeType
highlight default link asemeType_273 asemeType
highlight default link asemeType_318 asemeType
highlight default link asemeType_537 asemeType
highlight default link asemeType_542 asemeType
highlight default link asemeType_548 asemeType
highlight default link asemeType_550 asemeType
highlight default link asemeType_567 asemeType
highlight default link asemeType_618 asemeType
highlight default link asemeType_626 asemeType
highlight default link asemeType_750 asemeType
highlight default link asemeType_755 asemeType
highlight default link asemeType_761 asemeType
highlight default link asemeType_763 asemeType
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
