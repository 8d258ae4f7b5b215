" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
syntax sync fromstart
syntax match asemeReference_739 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_738 /\v\w+/
syntax match asemeNumber_737 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_736 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_735 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_740 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_735,asemeText_736,asemeNumber_737,asemeReference_738,asemeReference_739,asemePunctuation_740,asemeComment
syntax match asemeReference_42 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_41 /\v\w+/ contained
syntax match asemeNumber_40 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_39 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_38 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_43 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_30,asemeDeclaration_48,asemeDeclaration_74,asemeDeclaration_101,asemeDeclaration_131,asemeDeclaration_154,asemeDeclaration_186,asemeDeclaration_387,asemeDeclaration_599,asemeDeclaration_602,asemeDeclaration_670,asemeDeclaration_693,asemeDeclaration_722,asemeDeclaration_733,asemeText_735,asemeText_736,asemeNumber_737,asemeReference_738,asemeReference_739,asemePunctuation_740,asemeComment
syntax match asemeDeclaration_733 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_732,asemeComment_734 skipwhite skipempty
syntax region asemeComment_734 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_732,asemeComment_734 skipwhite skipempty
syntax match asemeComment_734 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_732,asemeComment_734 skipwhite skipempty
syntax match asemeText_732 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_731 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_729,asemeText_730
syntax match asemeText_730 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_731 skipwhite skipempty
syntax region asemePunctuation_729 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_712,asemeText_724,asemeNumber_725,asemeReference_726,asemeOperator_727,asemePunctuation_728,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_728 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_727 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_726 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_725 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_724 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_722 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax region asemeComment_723 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax match asemeComment_723 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_721,asemeComment_723 skipwhite skipempty
syntax match asemeText_721 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_720 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_718,asemeText_719
syntax match asemeText_719 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_720 skipwhite skipempty
syntax region asemePunctuation_718 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_712,asemeText_713,asemeNumber_714,asemeReference_715,asemeOperator_716,asemePunctuation_717,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_717 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_716 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_715 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_714 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_713 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_712 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_706,asemeText_707,asemeNumber_708,asemeReference_709,asemeOperator_710,asemePunctuation_711,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_711 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_710 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_709 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_708 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_707 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_706 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_700,asemeText_701,asemeNumber_702,asemeReference_703,asemeOperator_704,asemePunctuation_705,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_705 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_704 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_703 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_702 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_701 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_700 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_695,asemeNumber_696,asemeReference_697,asemeOperator_698,asemePunctuation_699,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_699 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_698 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_697 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_696 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_695 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_693 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_692,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_692,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_692,asemeComment_694 skipwhite skipempty
syntax match asemeBlock_692 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_691 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_689,asemeBlock_690
syntax match asemeBlock_690 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_691 skipwhite skipempty
syntax region asemeComment_691 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_691 skipwhite skipempty
syntax match asemeComment_691 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_691 skipwhite skipempty
syntax region asemePunctuation_689 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_688,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_688 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_673 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemePunctuation_680,asemePunctuation_683,asemePunctuation_686
syntax match asemePunctuation_686 /\v\:/ contained nextgroup=asemeReference_685,asemeComment_687 skipwhite skipempty
syntax region asemeComment_687 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_685,asemeComment_687 skipwhite skipempty
syntax match asemeComment_687 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_685,asemeComment_687 skipwhite skipempty
syntax match asemeReference_685 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_673 skipwhite skipempty
syntax match asemePunctuation_683 /\v\,/ contained nextgroup=asemeName_682,asemeComment_684 skipwhite skipempty
syntax region asemeComment_684 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_682,asemeComment_684 skipwhite skipempty
syntax match asemeComment_684 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_682,asemeComment_684 skipwhite skipempty
syntax match asemeName_682 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_673 skipwhite skipempty
syntax match asemePunctuation_680 /\v\[/ contained nextgroup=asemeNumber_678,asemeComment_681 skipwhite skipempty
syntax region asemeComment_681 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_678,asemeComment_681 skipwhite skipempty
syntax match asemeComment_681 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_678,asemeComment_681 skipwhite skipempty
syntax match asemeNumber_678 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_676,asemeComment_679 skipwhite skipempty
syntax region asemeComment_679 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_676,asemeComment_679 skipwhite skipempty
syntax match asemeComment_679 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_676,asemeComment_679 skipwhite skipempty
syntax match asemePunctuation_676 /\v\.\./ contained nextgroup=asemeNumber_674,asemeComment_677 skipwhite skipempty
syntax region asemeComment_677 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_674,asemeComment_677 skipwhite skipempty
syntax match asemeComment_677 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_674,asemeComment_677 skipwhite skipempty
syntax match asemeNumber_674 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_672,asemeComment_675 skipwhite skipempty
syntax region asemeComment_675 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_672,asemeComment_675 skipwhite skipempty
syntax match asemeComment_675 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_672,asemeComment_675 skipwhite skipempty
syntax match asemePunctuation_672 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_673 skipwhite skipempty
syntax region asemeComment_673 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_673 skipwhite skipempty
syntax match asemeComment_673 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_673 skipwhite skipempty
syntax match asemeDeclaration_670 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_669,asemeComment_671 skipwhite skipempty
syntax region asemeComment_671 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_669,asemeComment_671 skipwhite skipempty
syntax match asemeComment_671 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_669,asemeComment_671 skipwhite skipempty
syntax match asemeBlock_669 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_668 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_666,asemeBlock_667
syntax match asemeBlock_667 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_668 skipwhite skipempty
syntax region asemeComment_668 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_668 skipwhite skipempty
syntax match asemeComment_668 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_668 skipwhite skipempty
syntax region asemePunctuation_666 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_626,asemeNumber_633,asemeDeclaration_655,asemeDeclaration_660,asemeDeclaration_662,asemeDeclaration_664,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_664 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_665 skipwhite skipempty
syntax region asemeComment_665 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_665 skipwhite skipempty
syntax match asemeComment_665 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_665 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_577
syntax match asemeDeclaration_662 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_663 skipwhite skipempty
syntax region asemeComment_663 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_663 skipwhite skipempty
syntax match asemeComment_663 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_663 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_532
syntax match asemeDeclaration_660 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_658,asemeComment_661 skipwhite skipempty
syntax region asemeComment_661 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_658,asemeComment_661 skipwhite skipempty
syntax match asemeComment_661 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_658,asemeComment_661 skipwhite skipempty
syntax match asemeName_658 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_657,asemeComment_659 skipwhite skipempty
syntax region asemeComment_659 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_657,asemeComment_659 skipwhite skipempty
syntax match asemeComment_659 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_657,asemeComment_659 skipwhite skipempty
syntax match asemeOperator_657 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_655 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_653,asemeComment_656 skipwhite skipempty
syntax region asemeComment_656 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_653,asemeComment_656 skipwhite skipempty
syntax match asemeComment_656 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_653,asemeComment_656 skipwhite skipempty
syntax match asemeName_653 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_651,asemeComment_654 skipwhite skipempty
syntax region asemeComment_654 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_651,asemeComment_654 skipwhite skipempty
syntax match asemeComment_654 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_651,asemeComment_654 skipwhite skipempty
syntax match asemePunctuation_651 /\v\:/ contained nextgroup=asemeBuiltIn_649,asemeType_650,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_649,asemeType_650,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_649,asemeType_650,asemeComment_652 skipwhite skipempty
syntax match asemeType_650 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeBuiltIn_649 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_638,asemeOperator_640,asemeName_645,asemeBuiltIn_647,asemeType_648
syntax match asemeType_648 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeBuiltIn_647 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeName_645 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_643,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_643,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_643,asemeComment_646 skipwhite skipempty
syntax match asemePunctuation_643 /\v\:/ contained nextgroup=asemeBuiltIn_641,asemeType_642,asemeComment_644 skipwhite skipempty
syntax region asemeComment_644 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_641,asemeType_642,asemeComment_644 skipwhite skipempty
syntax match asemeComment_644 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_641,asemeType_642,asemeComment_644 skipwhite skipempty
syntax match asemeType_642 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeBuiltIn_641 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeOperator_640 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_638 /\v\:/ contained nextgroup=asemeBuiltIn_635,asemeType_637,asemeComment_639 skipwhite skipempty
syntax region asemeComment_639 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_635,asemeType_637,asemeComment_639 skipwhite skipempty
syntax match asemeComment_639 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_635,asemeType_637,asemeComment_639 skipwhite skipempty
syntax match asemeType_637 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeBuiltIn_635 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax region asemeComment_636 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeComment_636 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_636 skipwhite skipempty
syntax match asemeNumber_633 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_631,asemeComment_634 skipwhite skipempty
syntax region asemeComment_634 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_631,asemeComment_634 skipwhite skipempty
syntax match asemeComment_634 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_631,asemeComment_634 skipwhite skipempty
syntax match asemeOperator_631 /\v\-\>/ contained nextgroup=asemeNumber_629,asemeComment_632 skipwhite skipempty
syntax region asemeComment_632 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_629,asemeComment_632 skipwhite skipempty
syntax match asemeComment_632 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_629,asemeComment_632 skipwhite skipempty
syntax match asemeNumber_629 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_628,asemeComment_630 skipwhite skipempty
syntax region asemeComment_630 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_628,asemeComment_630 skipwhite skipempty
syntax match asemeComment_630 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_628,asemeComment_630 skipwhite skipempty
syntax match asemePunctuation_628 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeDeclaration_626 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_624,asemeComment_627 skipwhite skipempty
syntax region asemeComment_627 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_624,asemeComment_627 skipwhite skipempty
syntax match asemeComment_627 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_624,asemeComment_627 skipwhite skipempty
syntax match asemeNumber_624 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_622,asemeComment_625 skipwhite skipempty
syntax region asemeComment_625 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_622,asemeComment_625 skipwhite skipempty
syntax match asemeComment_625 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_622,asemeComment_625 skipwhite skipempty
syntax match asemeChoice_622 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_620,asemeText_621,@asemeChartNodeInBodyOfStatechart,asemeComment_623 skipwhite skipempty
syntax region asemeComment_623 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_620,asemeText_621,@asemeChartNodeInBodyOfStatechart,asemeComment_623 skipwhite skipempty
syntax match asemeComment_623 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_620,asemeText_621,@asemeChartNodeInBodyOfStatechart,asemeComment_623 skipwhite skipempty
syntax match asemeText_621 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeName_620 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_606,asemeChoice_610,asemeNumber_616,asemeName_618,asemeText_619
syntax match asemeText_619 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeName_618 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeNumber_616 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_614,asemeComment_617 skipwhite skipempty
syntax region asemeComment_617 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_614,asemeComment_617 skipwhite skipempty
syntax match asemeComment_617 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_614,asemeComment_617 skipwhite skipempty
syntax match asemeChoice_614 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_612,asemeText_613,@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax region asemeComment_615 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_612,asemeText_613,@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeComment_615 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_612,asemeText_613,@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeText_613 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeName_612 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeChoice_610 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_608,asemeText_609,@asemeChartNodeInBodyOfStatechart,asemeComment_611 skipwhite skipempty
syntax region asemeComment_611 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_608,asemeText_609,@asemeChartNodeInBodyOfStatechart,asemeComment_611 skipwhite skipempty
syntax match asemeComment_611 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_608,asemeText_609,@asemeChartNodeInBodyOfStatechart,asemeComment_611 skipwhite skipempty
syntax match asemeText_609 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeName_608 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeClause_606 /\vactivity%(<|>)/ contained nextgroup=asemeReference_604,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_604,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_604,asemeComment_607 skipwhite skipempty
syntax match asemeReference_604 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax region asemeComment_605 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeComment_605 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_605 skipwhite skipempty
syntax match asemeDeclaration_602 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_601,asemeComment_603 skipwhite skipempty
syntax region asemeComment_603 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_601,asemeComment_603 skipwhite skipempty
syntax match asemeComment_603 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_601,asemeComment_603 skipwhite skipempty
syntax match asemeBlock_601 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_390 skipwhite skipempty
syntax match asemeDeclaration_599 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_597,asemeComment_600 skipwhite skipempty
syntax region asemeComment_600 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_597,asemeComment_600 skipwhite skipempty
syntax match asemeComment_600 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_597,asemeComment_600 skipwhite skipempty
syntax match asemeClause_597 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_596,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_596,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_596,asemeComment_598 skipwhite skipempty
syntax match asemeBlock_596 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_390 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_391,asemePunctuation_594,asemeBlock_595
syntax match asemeBlock_595 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_390 skipwhite skipempty
syntax region asemePunctuation_594 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_399,asemeDeclaration_435,asemeDeclaration_451,asemeDeclaration_473,asemeDeclaration_478,asemeDeclaration_491,asemeDeclaration_533,asemeDeclaration_578,asemeDeclaration_587,asemeDeclaration_592,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_592 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_591,asemeComment_593 skipwhite skipempty
syntax region asemeComment_593 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_591,asemeComment_593 skipwhite skipempty
syntax match asemeComment_593 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_591,asemeComment_593 skipwhite skipempty
syntax match asemeBlock_591 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_377,asemeBlock_589
syntax match asemeBlock_589 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax match asemeDeclaration_587 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_586,asemeComment_588 skipwhite skipempty
syntax region asemeComment_588 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_586,asemeComment_588 skipwhite skipempty
syntax match asemeComment_588 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_586,asemeComment_588 skipwhite skipempty
syntax match asemeBlock_586 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_583,asemeBlock_584
syntax match asemeBlock_584 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_585 skipwhite skipempty
syntax region asemePunctuation_583 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_581,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_581 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_580,asemeComment_582 skipwhite skipempty
syntax region asemeComment_582 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_580,asemeComment_582 skipwhite skipempty
syntax match asemeComment_582 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_580,asemeComment_582 skipwhite skipempty
syntax match asemeText_580 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_578 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_579 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_577
syntax region asemePunctuation_577 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_576,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_576 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_540,asemeClause_543,asemeClause_546,asemeClause_549,asemeClause_552,asemeClause_555,asemeClause_558,asemeClause_561,asemeClause_564,asemePunctuation_571,asemeOperator_574
syntax match asemeOperator_574 /\v\=%(\=)@!/ contained nextgroup=asemeText_573,asemeComment_575 skipwhite skipempty
syntax region asemeComment_575 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_573,asemeComment_575 skipwhite skipempty
syntax match asemeComment_575 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_573,asemeComment_575 skipwhite skipempty
syntax match asemeText_573 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemePunctuation_571 /\v\,/ contained nextgroup=asemeChoice_567,asemeReference_569,asemeReference_570,asemeComment_572 skipwhite skipempty
syntax region asemeComment_572 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_567,asemeReference_569,asemeReference_570,asemeComment_572 skipwhite skipempty
syntax match asemeComment_572 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_567,asemeReference_569,asemeReference_570,asemeComment_572 skipwhite skipempty
syntax match asemeReference_570 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeReference_569 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeChoice_567 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_566,asemeComment_568 skipwhite skipempty
syntax region asemeComment_568 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_566,asemeComment_568 skipwhite skipempty
syntax match asemeComment_568 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_566,asemeComment_568 skipwhite skipempty
syntax match asemeReference_566 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_564 /\vends%(<|>)/ contained nextgroup=asemeReference_563,asemeComment_565 skipwhite skipempty
syntax region asemeComment_565 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_563,asemeComment_565 skipwhite skipempty
syntax match asemeComment_565 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_563,asemeComment_565 skipwhite skipempty
syntax match asemeReference_563 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_561 /\vwrites%(<|>)/ contained nextgroup=asemeReference_560,asemeComment_562 skipwhite skipempty
syntax region asemeComment_562 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_560,asemeComment_562 skipwhite skipempty
syntax match asemeComment_562 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_560,asemeComment_562 skipwhite skipempty
syntax match asemeReference_560 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_558 /\vfor%(<|>)/ contained nextgroup=asemeNumber_557,asemeComment_559 skipwhite skipempty
syntax region asemeComment_559 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_557,asemeComment_559 skipwhite skipempty
syntax match asemeComment_559 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_557,asemeComment_559 skipwhite skipempty
syntax match asemeNumber_557 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_555 /\vuses%(<|>)/ contained nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_554,asemeComment_556 skipwhite skipempty
syntax match asemeReference_554 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_552 /\vas%(<|>)/ contained nextgroup=asemeChoice_551,asemeComment_553 skipwhite skipempty
syntax region asemeComment_553 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_551,asemeComment_553 skipwhite skipempty
syntax match asemeComment_553 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_551,asemeComment_553 skipwhite skipempty
syntax match asemeChoice_551 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_549 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_548,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_548,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_548,asemeComment_550 skipwhite skipempty
syntax match asemeNumber_548 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_546 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax match asemeNumber_545 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_543 /\vevery%(<|>)/ contained nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax match asemeNumber_542 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeClause_540 /\vreads%(<|>)/ contained nextgroup=asemeChoice_537,asemeReference_539,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_537,asemeReference_539,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_537,asemeReference_539,asemeComment_541 skipwhite skipempty
syntax match asemeReference_539 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeChoice_537 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_535,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_535,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_535,asemeComment_538 skipwhite skipempty
syntax match asemeReference_535 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax region asemeComment_536 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeComment_536 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_536 skipwhite skipempty
syntax match asemeDeclaration_533 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_534 skipwhite skipempty
syntax region asemeComment_534 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_534 skipwhite skipempty
syntax match asemeComment_534 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_534 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_532
syntax region asemePunctuation_532 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_531,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_531 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_498,asemeClause_501,asemeClause_504,asemeClause_507,asemeClause_510,asemeClause_513,asemeClause_516,asemeClause_519,asemeClause_522,asemePunctuation_529
syntax match asemePunctuation_529 /\v\,/ contained nextgroup=asemeChoice_525,asemeReference_527,asemeReference_528,asemeComment_530 skipwhite skipempty
syntax region asemeComment_530 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_525,asemeReference_527,asemeReference_528,asemeComment_530 skipwhite skipempty
syntax match asemeComment_530 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_525,asemeReference_527,asemeReference_528,asemeComment_530 skipwhite skipempty
syntax match asemeReference_528 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeReference_527 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeChoice_525 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax region asemeComment_526 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeComment_526 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeReference_524 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_522 /\vends%(<|>)/ contained nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax region asemeComment_523 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax match asemeComment_523 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax match asemeReference_521 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_519 /\vwrites%(<|>)/ contained nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax region asemeComment_520 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax match asemeComment_520 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax match asemeReference_518 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_516 /\vfor%(<|>)/ contained nextgroup=asemeNumber_515,asemeComment_517 skipwhite skipempty
syntax region asemeComment_517 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_515,asemeComment_517 skipwhite skipempty
syntax match asemeComment_517 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_515,asemeComment_517 skipwhite skipempty
syntax match asemeNumber_515 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_513 /\vuses%(<|>)/ contained nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_512,asemeComment_514 skipwhite skipempty
syntax match asemeReference_512 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_510 /\vas%(<|>)/ contained nextgroup=asemeChoice_509,asemeComment_511 skipwhite skipempty
syntax region asemeComment_511 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_509,asemeComment_511 skipwhite skipempty
syntax match asemeComment_511 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_509,asemeComment_511 skipwhite skipempty
syntax match asemeChoice_509 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_507 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_506,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_506,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_506,asemeComment_508 skipwhite skipempty
syntax match asemeNumber_506 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_504 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_503,asemeComment_505 skipwhite skipempty
syntax region asemeComment_505 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_503,asemeComment_505 skipwhite skipempty
syntax match asemeComment_505 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_503,asemeComment_505 skipwhite skipempty
syntax match asemeNumber_503 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_501 /\vevery%(<|>)/ contained nextgroup=asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax region asemeComment_502 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax match asemeComment_502 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax match asemeNumber_500 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeClause_498 /\vreads%(<|>)/ contained nextgroup=asemeChoice_495,asemeReference_497,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_495,asemeReference_497,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_495,asemeReference_497,asemeComment_499 skipwhite skipempty
syntax match asemeReference_497 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeChoice_495 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_493,asemeComment_496 skipwhite skipempty
syntax region asemeComment_496 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_493,asemeComment_496 skipwhite skipempty
syntax match asemeComment_496 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_493,asemeComment_496 skipwhite skipempty
syntax match asemeReference_493 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax region asemeComment_494 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeComment_494 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_494 skipwhite skipempty
syntax match asemeDeclaration_491 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_492 skipwhite skipempty
syntax region asemeComment_492 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_492 skipwhite skipempty
syntax match asemeComment_492 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_492 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_490
syntax region asemePunctuation_490 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_488,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_488 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_487,asemeComment_489 skipwhite skipempty
syntax region asemeComment_489 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_487,asemeComment_489 skipwhite skipempty
syntax match asemeComment_489 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_487,asemeComment_489 skipwhite skipempty
syntax match asemeOperator_487 /\v\=%(\=)@!/ contained nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax cluster asemeFormula contains=asemeText_480,asemeNumber_482,asemeReference_483,asemeNumber_484,asemeOperator_485,asemePunctuation_486
syntax match asemePunctuation_486 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeOperator_485 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeNumber_484 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeReference_483 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeNumber_482 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeText_480 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax region asemeComment_481 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeComment_481 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormula,asemeComment_481 skipwhite skipempty
syntax match asemeDeclaration_478 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_476,asemeComment_479 skipwhite skipempty
syntax region asemeComment_479 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_476,asemeComment_479 skipwhite skipempty
syntax match asemeComment_479 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_476,asemeComment_479 skipwhite skipempty
syntax match asemeName_476 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_475,asemeComment_477 skipwhite skipempty
syntax region asemeComment_477 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_475,asemeComment_477 skipwhite skipempty
syntax match asemeComment_477 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_475,asemeComment_477 skipwhite skipempty
syntax match asemeOperator_475 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_473 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_471,asemeComment_474 skipwhite skipempty
syntax region asemeComment_474 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_471,asemeComment_474 skipwhite skipempty
syntax match asemeComment_474 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_471,asemeComment_474 skipwhite skipempty
syntax match asemeName_471 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_469,asemeComment_472 skipwhite skipempty
syntax region asemeComment_472 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_469,asemeComment_472 skipwhite skipempty
syntax match asemeComment_472 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_469,asemeComment_472 skipwhite skipempty
syntax match asemePunctuation_469 /\v\:/ contained nextgroup=asemeBuiltIn_467,asemeType_468,asemeComment_470 skipwhite skipempty
syntax region asemeComment_470 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_467,asemeType_468,asemeComment_470 skipwhite skipempty
syntax match asemeComment_470 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_467,asemeType_468,asemeComment_470 skipwhite skipempty
syntax match asemeType_468 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeBuiltIn_467 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_456,asemeOperator_458,asemeName_463,asemeBuiltIn_465,asemeType_466
syntax match asemeType_466 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeBuiltIn_465 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeName_463 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_461,asemeComment_464 skipwhite skipempty
syntax region asemeComment_464 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_461,asemeComment_464 skipwhite skipempty
syntax match asemeComment_464 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_461,asemeComment_464 skipwhite skipempty
syntax match asemePunctuation_461 /\v\:/ contained nextgroup=asemeBuiltIn_459,asemeType_460,asemeComment_462 skipwhite skipempty
syntax region asemeComment_462 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_459,asemeType_460,asemeComment_462 skipwhite skipempty
syntax match asemeComment_462 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_459,asemeType_460,asemeComment_462 skipwhite skipempty
syntax match asemeType_460 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeBuiltIn_459 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeOperator_458 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_456 /\v\:/ contained nextgroup=asemeBuiltIn_453,asemeType_455,asemeComment_457 skipwhite skipempty
syntax region asemeComment_457 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_453,asemeType_455,asemeComment_457 skipwhite skipempty
syntax match asemeComment_457 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_453,asemeType_455,asemeComment_457 skipwhite skipempty
syntax match asemeType_455 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeBuiltIn_453 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax region asemeComment_454 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeComment_454 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeDeclaration_451 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_449,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_449,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_449,asemeComment_452 skipwhite skipempty
syntax match asemeName_449 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_448,@asemeCapabilityInBodyOfSrm,asemeComment_450 skipwhite skipempty
syntax region asemeComment_450 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_448,@asemeCapabilityInBodyOfSrm,asemeComment_450 skipwhite skipempty
syntax match asemeComment_450 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_448,@asemeCapabilityInBodyOfSrm,asemeComment_450 skipwhite skipempty
syntax match asemeText_448 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_439,asemePunctuation_442,asemeText_444,asemeName_446
syntax match asemeName_446 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_445,@asemeCapabilityInBodyOfSrm,asemeComment_447 skipwhite skipempty
syntax region asemeComment_447 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_445,@asemeCapabilityInBodyOfSrm,asemeComment_447 skipwhite skipempty
syntax match asemeComment_447 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_445,@asemeCapabilityInBodyOfSrm,asemeComment_447 skipwhite skipempty
syntax match asemeText_445 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax match asemeText_444 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax match asemePunctuation_442 /\v\,/ contained nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax region asemeComment_443 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax match asemeComment_443 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax match asemeReference_441 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax match asemeOperator_439 /\v\=%(\=)@!/ contained nextgroup=asemeReference_437,asemeComment_440 skipwhite skipempty
syntax region asemeComment_440 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_437,asemeComment_440 skipwhite skipempty
syntax match asemeComment_440 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_437,asemeComment_440 skipwhite skipempty
syntax match asemeReference_437 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax region asemeComment_438 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax match asemeComment_438 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_438 skipwhite skipempty
syntax match asemeDeclaration_435 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_433,asemeComment_436 skipwhite skipempty
syntax region asemeComment_436 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_433,asemeComment_436 skipwhite skipempty
syntax match asemeComment_436 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_433,asemeComment_436 skipwhite skipempty
syntax match asemeReference_433 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_431,asemeComment_434 skipwhite skipempty
syntax region asemeComment_434 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_431,asemeComment_434 skipwhite skipempty
syntax match asemeComment_434 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_431,asemeComment_434 skipwhite skipempty
syntax match asemePunctuation_431 /\v\./ contained nextgroup=asemeReference_430,asemeComment_432 skipwhite skipempty
syntax region asemeComment_432 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_430,asemeComment_432 skipwhite skipempty
syntax match asemeComment_432 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_430,asemeComment_432 skipwhite skipempty
syntax match asemeReference_430 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_407,asemeClause_410,asemePunctuation_420,asemePunctuation_423,asemeReference_428
syntax match asemeReference_428 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_426,@asemePlaysInBodyOfSrm,asemeComment_429 skipwhite skipempty
syntax region asemeComment_429 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_426,@asemePlaysInBodyOfSrm,asemeComment_429 skipwhite skipempty
syntax match asemeComment_429 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_426,@asemePlaysInBodyOfSrm,asemeComment_429 skipwhite skipempty
syntax match asemePunctuation_426 /\v\./ contained nextgroup=asemeReference_425,asemeComment_427 skipwhite skipempty
syntax region asemeComment_427 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_425,asemeComment_427 skipwhite skipempty
syntax match asemeComment_427 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_425,asemeComment_427 skipwhite skipempty
syntax match asemeReference_425 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemePunctuation_423 /\v\./ contained nextgroup=asemeReference_422,asemeComment_424 skipwhite skipempty
syntax region asemeComment_424 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_422,asemeComment_424 skipwhite skipempty
syntax match asemeComment_424 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_422,asemeComment_424 skipwhite skipempty
syntax match asemeReference_422 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemePunctuation_420 /\v\,/ contained nextgroup=asemeReference_418,asemeComment_421 skipwhite skipempty
syntax region asemeComment_421 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_418,asemeComment_421 skipwhite skipempty
syntax match asemeComment_421 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_418,asemeComment_421 skipwhite skipempty
syntax match asemeReference_418 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_413,asemePunctuation_416,asemeComment_419 skipwhite skipempty
syntax region asemeComment_419 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_413,asemePunctuation_416,asemeComment_419 skipwhite skipempty
syntax match asemeComment_419 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_413,asemePunctuation_416,asemeComment_419 skipwhite skipempty
syntax match asemePunctuation_416 /\v\./ contained nextgroup=asemeReference_415,asemeComment_417 skipwhite skipempty
syntax region asemeComment_417 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_415,asemeComment_417 skipwhite skipempty
syntax match asemeComment_417 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_415,asemeComment_417 skipwhite skipempty
syntax match asemeReference_415 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemeOperator_413 /\v\=%(\=)@!/ contained nextgroup=asemeReference_412,asemeComment_414 skipwhite skipempty
syntax region asemeComment_414 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_412,asemeComment_414 skipwhite skipempty
syntax match asemeComment_414 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_412,asemeComment_414 skipwhite skipempty
syntax match asemeReference_412 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemeClause_410 /\vas%(<|>)/ contained nextgroup=asemeReference_409,asemeComment_411 skipwhite skipempty
syntax region asemeComment_411 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_409,asemeComment_411 skipwhite skipempty
syntax match asemeComment_411 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_409,asemeComment_411 skipwhite skipempty
syntax match asemeReference_409 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemeClause_407 /\vwith%(<|>)/ contained nextgroup=asemeReference_405,asemeComment_408 skipwhite skipempty
syntax region asemeComment_408 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_405,asemeComment_408 skipwhite skipempty
syntax match asemeComment_408 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_405,asemeComment_408 skipwhite skipempty
syntax match asemeReference_405 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_403,asemeComment_406 skipwhite skipempty
syntax region asemeComment_406 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_403,asemeComment_406 skipwhite skipempty
syntax match asemeComment_406 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_403,asemeComment_406 skipwhite skipempty
syntax match asemeOperator_403 /\v\=%(\=)@!/ contained nextgroup=asemeReference_401,asemeComment_404 skipwhite skipempty
syntax region asemeComment_404 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_401,asemeComment_404 skipwhite skipempty
syntax match asemeComment_404 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_401,asemeComment_404 skipwhite skipempty
syntax match asemeReference_401 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax region asemeComment_402 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemeComment_402 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_402 skipwhite skipempty
syntax match asemeDeclaration_399 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_398,asemeComment_400 skipwhite skipempty
syntax region asemeComment_400 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_398,asemeComment_400 skipwhite skipempty
syntax match asemeComment_400 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_398,asemeComment_400 skipwhite skipempty
syntax match asemeReference_398 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_394 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_395,asemeReference_397
syntax match asemeReference_397 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_394 skipwhite skipempty
syntax match asemePunctuation_395 /\v\,/ contained nextgroup=asemeReference_393,asemeComment_396 skipwhite skipempty
syntax region asemeComment_396 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_393,asemeComment_396 skipwhite skipempty
syntax match asemeComment_396 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_393,asemeComment_396 skipwhite skipempty
syntax match asemeReference_393 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_394 skipwhite skipempty
syntax region asemeComment_394 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_394 skipwhite skipempty
syntax match asemeComment_394 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_394 skipwhite skipempty
syntax match asemeClause_391 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_389,asemeComment_392 skipwhite skipempty
syntax region asemeComment_392 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_389,asemeComment_392 skipwhite skipempty
syntax match asemeComment_392 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_389,asemeComment_392 skipwhite skipempty
syntax match asemeBlock_389 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_390 skipwhite skipempty
syntax region asemeComment_390 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_390 skipwhite skipempty
syntax match asemeComment_390 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_390 skipwhite skipempty
syntax match asemeDeclaration_387 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_386,asemeComment_388 skipwhite skipempty
syntax region asemeComment_388 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_386,asemeComment_388 skipwhite skipempty
syntax match asemeComment_388 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_386,asemeComment_388 skipwhite skipempty
syntax match asemeBlock_386 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_385 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_383,asemeBlock_384
syntax match asemeBlock_384 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_385 skipwhite skipempty
syntax region asemeComment_385 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_385 skipwhite skipempty
syntax match asemeComment_385 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_385 skipwhite skipempty
syntax region asemePunctuation_383 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_284,asemeDeclaration_287,asemeDeclaration_315,asemeDeclaration_319,asemeDeclaration_381,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_381 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_380,asemeComment_382 skipwhite skipempty
syntax region asemeComment_382 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_380,asemeComment_382 skipwhite skipempty
syntax match asemeComment_382 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_380,asemeComment_382 skipwhite skipempty
syntax match asemeBlock_380 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_377,asemeBlock_378
syntax match asemeBlock_378 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
syntax region asemeComment_379 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
syntax match asemeComment_379 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
syntax region asemePunctuation_377 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_352,asemeNumber_375,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeNumber_375 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_373,asemeComment_376 skipwhite skipempty
syntax region asemeComment_376 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_373,asemeComment_376 skipwhite skipempty
syntax match asemeComment_376 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_373,asemeComment_376 skipwhite skipempty
syntax match asemeOperator_373 /\v\-\>/ contained nextgroup=asemeNumber_371,asemeComment_374 skipwhite skipempty
syntax region asemeComment_374 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_371,asemeComment_374 skipwhite skipempty
syntax match asemeComment_374 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_371,asemeComment_374 skipwhite skipempty
syntax match asemeNumber_371 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_370,asemeComment_372 skipwhite skipempty
syntax region asemeComment_372 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_370,asemeComment_372 skipwhite skipempty
syntax match asemeComment_372 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_370,asemeComment_372 skipwhite skipempty
syntax match asemePunctuation_370 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeText_353,asemeNumber_355,asemeTruth_356,asemeLogic_357,asemeClause_358,asemeClause_359,asemeClause_360,asemeClause_361,asemeClause_362,asemeClause_363,asemeClause_364,asemeClause_365,asemeCall_366,asemeReference_367,asemeOperator_368,asemePunctuation_369
syntax match asemePunctuation_369 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeOperator_368 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeReference_367 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeCall_366 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_365 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_364 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_363 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_362 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_361 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_360 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_359 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeClause_358 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeLogic_357 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeTruth_356 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeNumber_355 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeText_353 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax region asemeComment_354 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeComment_354 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeDeclaration_352 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_323,asemeOperator_326,asemePunctuation_345,asemeText_346,asemeNumber_347,asemeReference_348,asemeNumber_349,asemeOperator_350,asemePunctuation_351
syntax match asemePunctuation_351 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeOperator_350 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeNumber_349 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeReference_348 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeNumber_347 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeText_346 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemePunctuation_345 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeText_328,asemeNumber_330,asemeTruth_331,asemeLogic_332,asemeClause_333,asemeClause_334,asemeClause_335,asemeClause_336,asemeClause_337,asemeClause_338,asemeClause_339,asemeClause_340,asemeCall_341,asemeReference_342,asemeOperator_343,asemePunctuation_344
syntax match asemePunctuation_344 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeOperator_343 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeReference_342 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeCall_341 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_340 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_339 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_338 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_337 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_336 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_335 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_334 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeClause_333 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeLogic_332 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeTruth_331 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeNumber_330 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeText_328 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax region asemeComment_329 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeComment_329 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_329 skipwhite skipempty
syntax match asemeOperator_326 /\v\#/ contained nextgroup=asemeNumber_325,asemeComment_327 skipwhite skipempty
syntax region asemeComment_327 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_325,asemeComment_327 skipwhite skipempty
syntax match asemeComment_327 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_325,asemeComment_327 skipwhite skipempty
syntax match asemeNumber_325 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeClause_323 /\vevery%(<|>)/ contained nextgroup=asemeNumber_321,asemeComment_324 skipwhite skipempty
syntax region asemeComment_324 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_321,asemeComment_324 skipwhite skipempty
syntax match asemeComment_324 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_321,asemeComment_324 skipwhite skipempty
syntax match asemeNumber_321 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax region asemeComment_322 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeComment_322 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeDeclaration_319 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_317,asemeComment_320 skipwhite skipempty
syntax region asemeComment_320 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_317,asemeComment_320 skipwhite skipempty
syntax match asemeComment_320 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_317,asemeComment_320 skipwhite skipempty
syntax match asemeName_317 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_316,asemeComment_318 skipwhite skipempty
syntax region asemeComment_318 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_316,asemeComment_318 skipwhite skipempty
syntax match asemeComment_318 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_316,asemeComment_318 skipwhite skipempty
syntax match asemeOperator_316 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_315 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_294,asemeClause_297,asemeClause_300,asemeClause_303,asemeClause_305,asemeClause_306,asemePunctuation_308,asemeOperator_311,asemePunctuation_313,asemeName_314
syntax match asemeName_314 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemePunctuation_313 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeOperator_311 /\v\@/ contained nextgroup=asemeReference_310,asemeComment_312 skipwhite skipempty
syntax region asemeComment_312 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_310,asemeComment_312 skipwhite skipempty
syntax match asemeComment_312 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_310,asemeComment_312 skipwhite skipempty
syntax match asemeReference_310 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemePunctuation_308 /\v\(/ contained nextgroup=asemeName_307,asemeComment_309 skipwhite skipempty
syntax region asemeComment_309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_307,asemeComment_309 skipwhite skipempty
syntax match asemeComment_309 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_307,asemeComment_309 skipwhite skipempty
syntax match asemeName_307 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeClause_306 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeClause_305 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeClause_303 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_302,asemeComment_304 skipwhite skipempty
syntax region asemeComment_304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_302,asemeComment_304 skipwhite skipempty
syntax match asemeComment_304 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_302,asemeComment_304 skipwhite skipempty
syntax match asemeNumber_302 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeClause_300 /\vleads%(<|>)/ contained nextgroup=asemeClause_299,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_299,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_299,asemeComment_301 skipwhite skipempty
syntax match asemeClause_299 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeClause_297 /\vor%(<|>)/ contained nextgroup=asemeName_296,asemeComment_298 skipwhite skipempty
syntax region asemeComment_298 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_296,asemeComment_298 skipwhite skipempty
syntax match asemeComment_298 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_296,asemeComment_298 skipwhite skipempty
syntax match asemeName_296 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeClause_294 /\vat%(<|>)/ contained nextgroup=asemeClause_292,asemeComment_295 skipwhite skipempty
syntax region asemeComment_295 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_292,asemeComment_295 skipwhite skipempty
syntax match asemeComment_295 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_292,asemeComment_295 skipwhite skipempty
syntax match asemeClause_292 /\vmost%(<|>)/ contained nextgroup=asemeChoice_289,asemeNumber_291,asemeComment_293 skipwhite skipempty
syntax region asemeComment_293 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_289,asemeNumber_291,asemeComment_293 skipwhite skipempty
syntax match asemeComment_293 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_289,asemeNumber_291,asemeComment_293 skipwhite skipempty
syntax match asemeNumber_291 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeChoice_289 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax region asemeComment_290 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeComment_290 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_290 skipwhite skipempty
syntax match asemeDeclaration_287 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_286,asemeComment_288 skipwhite skipempty
syntax region asemeComment_288 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_286,asemeComment_288 skipwhite skipempty
syntax match asemeComment_288 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_286,asemeComment_288 skipwhite skipempty
syntax match asemeText_286 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_284 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_283,asemeComment_285 skipwhite skipempty
syntax region asemeComment_285 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_283,asemeComment_285 skipwhite skipempty
syntax match asemeComment_285 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_283,asemeComment_285 skipwhite skipempty
syntax match asemeBlock_283 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_190,asemePunctuation_193,asemePunctuation_195,asemePunctuation_281,asemeBlock_282
syntax match asemeBlock_282 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax region asemePunctuation_281 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_197,asemeDeclaration_236,asemeDeclaration_241,asemeDeclaration_255,asemeDeclaration_269,asemeName_279,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_279 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_278,asemeComment_280 skipwhite skipempty
syntax region asemeComment_280 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_278,asemeComment_280 skipwhite skipempty
syntax match asemeComment_280 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_278,asemeComment_280 skipwhite skipempty
syntax match asemeOperator_278 /\v\=%(\=)@!/ contained nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax cluster asemeProcess contains=asemeText_271,asemeNumber_273,asemeReference_274,asemeNumber_275,asemeOperator_276,asemePunctuation_277
syntax match asemePunctuation_277 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeOperator_276 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeNumber_275 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeReference_274 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeNumber_273 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeText_271 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax region asemeComment_272 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeComment_272 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcess,asemeComment_272 skipwhite skipempty
syntax match asemeDeclaration_269 /\v%(receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_267,asemeComment_270 skipwhite skipempty
syntax region asemeComment_270 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_267,asemeComment_270 skipwhite skipempty
syntax match asemeComment_270 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_267,asemeComment_270 skipwhite skipempty
syntax match asemeReference_267 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax region asemeComment_268 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax match asemeComment_268 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax match asemeReference_266 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_261,asemeReference_264
syntax match asemeReference_264 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=asemeReference_263,@asemeReceivesInBodyOfParticipant,asemeComment_265 skipwhite skipempty
syntax region asemeComment_265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_263,@asemeReceivesInBodyOfParticipant,asemeComment_265 skipwhite skipempty
syntax match asemeComment_265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_263,@asemeReceivesInBodyOfParticipant,asemeComment_265 skipwhite skipempty
syntax match asemeReference_263 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemePunctuation_261 /\v\,/ contained nextgroup=asemeReference_259,asemeComment_262 skipwhite skipempty
syntax region asemeComment_262 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_259,asemeComment_262 skipwhite skipempty
syntax match asemeComment_262 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_259,asemeComment_262 skipwhite skipempty
syntax match asemeReference_259 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=asemeReference_257,asemeComment_260 skipwhite skipempty
syntax region asemeComment_260 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_257,asemeComment_260 skipwhite skipempty
syntax match asemeComment_260 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_257,asemeComment_260 skipwhite skipempty
syntax match asemeReference_257 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax region asemeComment_258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeComment_258 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeDeclaration_255 /\v%(sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax region asemeComment_256 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax match asemeComment_256 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax match asemeReference_253 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=asemeReference_252,asemeComment_254 skipwhite skipempty
syntax region asemeComment_254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_252,asemeComment_254 skipwhite skipempty
syntax match asemeComment_254 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_252,asemeComment_254 skipwhite skipempty
syntax match asemeReference_252 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemePunctuation_247,asemeReference_250
syntax match asemeReference_250 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=asemeReference_249,@asemeSendsInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax region asemeComment_251 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_249,@asemeSendsInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeComment_251 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_249,@asemeSendsInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeReference_249 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax match asemePunctuation_247 /\v\,/ contained nextgroup=asemeReference_245,asemeComment_248 skipwhite skipempty
syntax region asemeComment_248 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_245,asemeComment_248 skipwhite skipempty
syntax match asemeComment_248 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_245,asemeComment_248 skipwhite skipempty
syntax match asemeReference_245 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=asemeReference_243,asemeComment_246 skipwhite skipempty
syntax region asemeComment_246 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_243,asemeComment_246 skipwhite skipempty
syntax match asemeComment_246 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_243,asemeComment_246 skipwhite skipempty
syntax match asemeReference_243 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax region asemeComment_244 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax match asemeComment_244 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax match asemeDeclaration_241 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_239,asemeComment_242 skipwhite skipempty
syntax region asemeComment_242 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_239,asemeComment_242 skipwhite skipempty
syntax match asemeComment_242 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_239,asemeComment_242 skipwhite skipempty
syntax match asemeName_239 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_238,asemeComment_240 skipwhite skipempty
syntax region asemeComment_240 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_238,asemeComment_240 skipwhite skipempty
syntax match asemeComment_240 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_238,asemeComment_240 skipwhite skipempty
syntax match asemeOperator_238 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_236 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_234,asemeComment_237 skipwhite skipempty
syntax region asemeComment_237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_234,asemeComment_237 skipwhite skipempty
syntax match asemeComment_237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_234,asemeComment_237 skipwhite skipempty
syntax match asemeName_234 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_232,asemeComment_235 skipwhite skipempty
syntax region asemeComment_235 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_232,asemeComment_235 skipwhite skipempty
syntax match asemeComment_235 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_232,asemeComment_235 skipwhite skipempty
syntax match asemePunctuation_232 /\v\:/ contained nextgroup=asemeBuiltIn_230,asemeType_231,asemeComment_233 skipwhite skipempty
syntax region asemeComment_233 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_230,asemeType_231,asemeComment_233 skipwhite skipempty
syntax match asemeComment_233 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_230,asemeType_231,asemeComment_233 skipwhite skipempty
syntax match asemeType_231 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_230 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemePunctuation_202,asemeOperator_221,asemeName_226,asemeBuiltIn_228,asemeType_229
syntax match asemeType_229 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_228 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeName_226 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=)@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_224,asemeComment_227 skipwhite skipempty
syntax region asemeComment_227 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_224,asemeComment_227 skipwhite skipempty
syntax match asemeComment_227 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_224,asemeComment_227 skipwhite skipempty
syntax match asemePunctuation_224 /\v\:/ contained nextgroup=asemeBuiltIn_222,asemeType_223,asemeComment_225 skipwhite skipempty
syntax region asemeComment_225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_222,asemeType_223,asemeComment_225 skipwhite skipempty
syntax match asemeComment_225 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_222,asemeType_223,asemeComment_225 skipwhite skipempty
syntax match asemeType_223 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_222 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeOperator_221 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax cluster asemeExpressionToken contains=asemeText_204,asemeNumber_206,asemeTruth_207,asemeLogic_208,asemeClause_209,asemeClause_210,asemeClause_211,asemeClause_212,asemeClause_213,asemeClause_214,asemeClause_215,asemeClause_216,asemeCall_217,asemeReference_218,asemeOperator_219,asemePunctuation_220
syntax match asemePunctuation_220 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeOperator_219 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeReference_218 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeCall_217 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_216 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_215 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_214 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_213 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_212 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_211 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_210 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_209 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeLogic_208 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeTruth_207 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeNumber_206 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeText_204 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax region asemeComment_205 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeComment_205 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_202 /\v\:/ contained nextgroup=asemeBuiltIn_199,asemeType_201,asemeComment_203 skipwhite skipempty
syntax region asemeComment_203 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_199,asemeType_201,asemeComment_203 skipwhite skipempty
syntax match asemeComment_203 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_199,asemeType_201,asemeComment_203 skipwhite skipempty
syntax match asemeType_201 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_199 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax region asemeComment_200 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeComment_200 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeDeclaration_197 /\v%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=engage%(<|>)/ contained nextgroup=asemeText_196,asemeComment_198 skipwhite skipempty
syntax region asemeComment_198 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_196,asemeComment_198 skipwhite skipempty
syntax match asemeComment_198 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_196,asemeComment_198 skipwhite skipempty
syntax match asemeText_196 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemePunctuation_195 /\v\]/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax match asemePunctuation_193 /\v\.\./ contained nextgroup=asemeNumber_192,asemeComment_194 skipwhite skipempty
syntax region asemeComment_194 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_192,asemeComment_194 skipwhite skipempty
syntax match asemeComment_194 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_192,asemeComment_194 skipwhite skipempty
syntax match asemeNumber_192 /\v%(\*|[0-9]+%(%(\w|\.[0-9]))@!)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax match asemePunctuation_190 /\v\[/ contained nextgroup=asemeNumber_188,asemeComment_191 skipwhite skipempty
syntax region asemeComment_191 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_188,asemeComment_191 skipwhite skipempty
syntax match asemeComment_191 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_188,asemeComment_191 skipwhite skipempty
syntax match asemeNumber_188 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax region asemeComment_189 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax match asemeComment_189 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax match asemeDeclaration_186 /\v%(suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=suc%(<|>)/ nextgroup=@asemeSucInFile,asemeComment_187 skipwhite skipempty
syntax region asemeComment_187 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_187 skipwhite skipempty
syntax match asemeComment_187 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSucInFile,asemeComment_187 skipwhite skipempty
syntax cluster asemeSucInFile contains=asemePunctuation_185
syntax region asemePunctuation_185 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfSuc
syntax cluster asemeBodyOfSuc contains=asemeDeclaration_165,asemeDeclaration_183,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_183 /\v%(usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=usecase%(<|>)/ contained nextgroup=asemeName_182,asemeComment_184 skipwhite skipempty
syntax region asemeComment_184 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_182,asemeComment_184 skipwhite skipempty
syntax match asemeComment_184 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_182,asemeComment_184 skipwhite skipempty
syntax match asemeName_182 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax cluster asemeUseCaseInBodyOfSuc contains=asemeClause_169,asemeClause_172,asemeClause_175,asemePunctuation_178,asemeText_180,asemeName_181
syntax match asemeName_181 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemeText_180 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemePunctuation_178 /\v\,/ contained nextgroup=asemeReference_177,asemeComment_179 skipwhite skipempty
syntax region asemeComment_179 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_177,asemeComment_179 skipwhite skipempty
syntax match asemeComment_179 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_177,asemeComment_179 skipwhite skipempty
syntax match asemeReference_177 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemeClause_175 /\vrealises%(<|>)/ contained nextgroup=asemeReference_174,asemeComment_176 skipwhite skipempty
syntax region asemeComment_176 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_174,asemeComment_176 skipwhite skipempty
syntax match asemeComment_176 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_174,asemeComment_176 skipwhite skipempty
syntax match asemeReference_174 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemeClause_172 /\vincludes%(<|>)/ contained nextgroup=asemeReference_171,asemeComment_173 skipwhite skipempty
syntax region asemeComment_173 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_171,asemeComment_173 skipwhite skipempty
syntax match asemeComment_173 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_171,asemeComment_173 skipwhite skipempty
syntax match asemeReference_171 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemeClause_169 /\vby%(<|>)/ contained nextgroup=asemeReference_167,asemeComment_170 skipwhite skipempty
syntax region asemeComment_170 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_167,asemeComment_170 skipwhite skipempty
syntax match asemeComment_170 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_167,asemeComment_170 skipwhite skipempty
syntax match asemeReference_167 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax region asemeComment_168 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemeComment_168 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeUseCaseInBodyOfSuc,asemeComment_168 skipwhite skipempty
syntax match asemeDeclaration_165 /\v%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=role%(<|>)/ contained nextgroup=asemeReference_164,asemeComment_166 skipwhite skipempty
syntax region asemeComment_166 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_164,asemeComment_166 skipwhite skipempty
syntax match asemeComment_166 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_164,asemeComment_166 skipwhite skipempty
syntax match asemeReference_164 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_157 skipwhite skipempty
syntax cluster asemeRolesInBodyOfSuc contains=asemePunctuation_158,asemePunctuation_161,asemeReference_163
syntax match asemeReference_163 /\v%(%(role%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|usecase%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_157 skipwhite skipempty
syntax match asemePunctuation_161 /\v\:/ contained nextgroup=asemeChoice_160,asemeComment_162 skipwhite skipempty
syntax region asemeComment_162 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_160,asemeComment_162 skipwhite skipempty
syntax match asemeComment_162 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_160,asemeComment_162 skipwhite skipempty
syntax match asemeChoice_160 /\v%(system|abstract|human|legacy|external)%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_157 skipwhite skipempty
syntax match asemePunctuation_158 /\v\,/ contained nextgroup=asemeReference_156,asemeComment_159 skipwhite skipempty
syntax region asemeComment_159 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_156,asemeComment_159 skipwhite skipempty
syntax match asemeComment_159 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_156,asemeComment_159 skipwhite skipempty
syntax match asemeReference_156 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeRolesInBodyOfSuc,asemeComment_157 skipwhite skipempty
syntax region asemeComment_157 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_157 skipwhite skipempty
syntax match asemeComment_157 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeRolesInBodyOfSuc,asemeComment_157 skipwhite skipempty
syntax match asemeDeclaration_154 /\v%(sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=sag%(<|>)/ nextgroup=@asemeSagInFile,asemeComment_155 skipwhite skipempty
syntax region asemeComment_155 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_155 skipwhite skipempty
syntax match asemeComment_155 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSagInFile,asemeComment_155 skipwhite skipempty
syntax cluster asemeSagInFile contains=asemePunctuation_153
syntax region asemePunctuation_153 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfSag
syntax cluster asemeBodyOfSag contains=asemeDeclaration_151,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_151 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=actor%(<|>)/ contained nextgroup=asemeBlock_150,asemeComment_152 skipwhite skipempty
syntax region asemeComment_152 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_150,asemeComment_152 skipwhite skipempty
syntax match asemeComment_152 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_150,asemeComment_152 skipwhite skipempty
syntax match asemeBlock_150 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_149 skipwhite skipempty
syntax cluster asemeActorInBodyOfSag contains=asemePunctuation_147,asemeBlock_148
syntax match asemeBlock_148 /\v%(actor%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActorInBodyOfSag,asemeComment_149 skipwhite skipempty
syntax region asemeComment_149 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_149 skipwhite skipempty
syntax match asemeComment_149 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActorInBodyOfSag,asemeComment_149 skipwhite skipempty
syntax region asemePunctuation_147 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfActor
syntax cluster asemeBodyOfActor contains=asemeDeclaration_145,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_145 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=goal%(<|>)/ contained nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax region asemeComment_146 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax match asemeComment_146 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_144,asemeComment_146 skipwhite skipempty
syntax match asemeName_144 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax cluster asemeGoalInBodyOfActor contains=asemeClause_137,asemePunctuation_140,asemeText_142,asemeName_143
syntax match asemeName_143 /\v%(goal%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax match asemeText_142 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax match asemePunctuation_140 /\v\,/ contained nextgroup=asemeReference_139,asemeComment_141 skipwhite skipempty
syntax region asemeComment_141 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_139,asemeComment_141 skipwhite skipempty
syntax match asemeComment_141 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_139,asemeComment_141 skipwhite skipempty
syntax match asemeReference_139 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax match asemeClause_137 /\vdepends%(<|>)/ contained nextgroup=asemeClause_135,asemeComment_138 skipwhite skipempty
syntax region asemeComment_138 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_135,asemeComment_138 skipwhite skipempty
syntax match asemeComment_138 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_135,asemeComment_138 skipwhite skipempty
syntax match asemeClause_135 /\von%(<|>)/ contained nextgroup=asemeReference_133,asemeComment_136 skipwhite skipempty
syntax region asemeComment_136 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_133,asemeComment_136 skipwhite skipempty
syntax match asemeComment_136 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_133,asemeComment_136 skipwhite skipempty
syntax match asemeReference_133 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax region asemeComment_134 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax match asemeComment_134 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeGoalInBodyOfActor,asemeComment_134 skipwhite skipempty
syntax match asemeDeclaration_131 /\v%(function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=function%(<|>)/ nextgroup=asemeName_129,asemeComment_132 skipwhite skipempty
syntax region asemeComment_132 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_129,asemeComment_132 skipwhite skipempty
syntax match asemeComment_132 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_129,asemeComment_132 skipwhite skipempty
syntax match asemeName_129 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_128,asemeComment_130 skipwhite skipempty
syntax region asemeComment_130 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_128,asemeComment_130 skipwhite skipempty
syntax match asemeComment_130 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_128,asemeComment_130 skipwhite skipempty
syntax match asemePunctuation_128 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_112,asemePunctuation_118,asemePunctuation_120,asemeBuiltIn_122,asemeType_124,asemeName_126
syntax match asemeName_126 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_125,asemeComment_127 skipwhite skipempty
syntax region asemeComment_127 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_125,asemeComment_127 skipwhite skipempty
syntax match asemeComment_127 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_125,asemeComment_127 skipwhite skipempty
syntax match asemePunctuation_125 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemeType_124 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax match asemeBuiltIn_122 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax region asemeComment_123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax match asemeComment_123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax match asemeName_121 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemePunctuation_120 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemePunctuation_118 /\v\,/ contained nextgroup=asemeBuiltIn_115,asemeType_117,asemeComment_119 skipwhite skipempty
syntax region asemeComment_119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_115,asemeType_117,asemeComment_119 skipwhite skipempty
syntax match asemeComment_119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_115,asemeType_117,asemeComment_119 skipwhite skipempty
syntax match asemeType_117 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax match asemeBuiltIn_115 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax match asemeName_114 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemePunctuation_112 /\v\)/ contained nextgroup=asemePunctuation_110,asemeComment_113 skipwhite skipempty
syntax region asemeComment_113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_110,asemeComment_113 skipwhite skipempty
syntax match asemeComment_113 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_110,asemeComment_113 skipwhite skipempty
syntax match asemePunctuation_110 /\v\:/ contained nextgroup=asemeBuiltIn_107,asemeType_109,asemeComment_111 skipwhite skipempty
syntax region asemeComment_111 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_107,asemeType_109,asemeComment_111 skipwhite skipempty
syntax match asemeComment_111 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_107,asemeType_109,asemeComment_111 skipwhite skipempty
syntax match asemeType_109 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_105,asemeComment_108 skipwhite skipempty
syntax match asemeBuiltIn_107 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=asemeOperator_105,asemeComment_108 skipwhite skipempty
syntax region asemeComment_108 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_105,asemeComment_108 skipwhite skipempty
syntax match asemeComment_108 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_105,asemeComment_108 skipwhite skipempty
syntax match asemeOperator_105 /\v\=%(\=)@!/ contained nextgroup=asemeText_103,asemeComment_106 skipwhite skipempty
syntax region asemeComment_106 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_103,asemeComment_106 skipwhite skipempty
syntax match asemeComment_106 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_103,asemeComment_106 skipwhite skipempty
syntax match asemeText_103 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax region asemeComment_104 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemeComment_104 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemeDeclaration_101 /\v%(topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=topic%(<|>)/ nextgroup=asemeBlock_100,asemeComment_102 skipwhite skipempty
syntax region asemeComment_102 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_100,asemeComment_102 skipwhite skipempty
syntax match asemeComment_102 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_100,asemeComment_102 skipwhite skipempty
syntax match asemeBlock_100 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_77 skipwhite skipempty
syntax cluster asemeTopicInFile contains=asemeClause_78,asemeClause_81,asemePunctuation_98,asemeBlock_99
syntax match asemeBlock_99 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_77 skipwhite skipempty
syntax region asemePunctuation_98 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfTopic
syntax cluster asemeBodyOfTopic contains=asemeDeclaration_96,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_96 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=%(signal|state|data)%(<|>)/ contained nextgroup=asemeReference_95,asemeComment_97 skipwhite skipempty
syntax region asemeComment_97 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_95,asemeComment_97 skipwhite skipempty
syntax match asemeComment_97 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_95,asemeComment_97 skipwhite skipempty
syntax match asemeReference_95 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax cluster asemeTopicMessagesInBodyOfTopic contains=asemeClause_85,asemeClause_88,asemeChoice_90,asemePunctuation_92,asemeReference_94
syntax match asemeReference_94 /\v%(%(signal|state|data)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax match asemePunctuation_92 /\v\,/ contained nextgroup=asemeReference_91,asemeComment_93 skipwhite skipempty
syntax region asemeComment_93 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_91,asemeComment_93 skipwhite skipempty
syntax match asemeComment_93 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_91,asemeComment_93 skipwhite skipempty
syntax match asemeReference_91 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax match asemeChoice_90 /\v%(queued|persist)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax match asemeClause_88 /\vevery%(<|>)/ contained nextgroup=asemeNumber_87,asemeComment_89 skipwhite skipempty
syntax region asemeComment_89 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_87,asemeComment_89 skipwhite skipempty
syntax match asemeComment_89 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_87,asemeComment_89 skipwhite skipempty
syntax match asemeNumber_87 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax match asemeClause_85 /\vfrom%(<|>)/ contained nextgroup=asemeReference_83,asemeComment_86 skipwhite skipempty
syntax region asemeComment_86 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_83,asemeComment_86 skipwhite skipempty
syntax match asemeComment_86 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_83,asemeComment_86 skipwhite skipempty
syntax match asemeReference_83 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax region asemeComment_84 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax match asemeComment_84 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicMessagesInBodyOfTopic,asemeComment_84 skipwhite skipempty
syntax match asemeClause_81 /\vradio%(<|>)/ contained nextgroup=asemeNumber_80,asemeComment_82 skipwhite skipempty
syntax region asemeComment_82 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_80,asemeComment_82 skipwhite skipempty
syntax match asemeComment_82 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_80,asemeComment_82 skipwhite skipempty
syntax match asemeNumber_80 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeTopicInFile,asemeComment_77 skipwhite skipempty
syntax match asemeClause_78 /\vunder%(<|>)/ contained nextgroup=asemeReference_76,asemeComment_79 skipwhite skipempty
syntax region asemeComment_79 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_76,asemeComment_79 skipwhite skipempty
syntax match asemeComment_79 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_76,asemeComment_79 skipwhite skipempty
syntax match asemeReference_76 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTopicInFile,asemeComment_77 skipwhite skipempty
syntax region asemeComment_77 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_77 skipwhite skipempty
syntax match asemeComment_77 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTopicInFile,asemeComment_77 skipwhite skipempty
syntax match asemeDeclaration_74 /\v%(message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=message%(<|>)/ nextgroup=asemeBlock_73,asemeComment_75 skipwhite skipempty
syntax region asemeComment_75 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_73,asemeComment_75 skipwhite skipempty
syntax match asemeComment_75 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_73,asemeComment_75 skipwhite skipempty
syntax match asemeBlock_73 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_72 skipwhite skipempty
syntax cluster asemeMessageInFile contains=asemePunctuation_70,asemeBlock_71
syntax match asemeBlock_71 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeMessageInFile,asemeComment_72 skipwhite skipempty
syntax region asemeComment_72 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_72 skipwhite skipempty
syntax match asemeComment_72 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeMessageInFile,asemeComment_72 skipwhite skipempty
syntax region asemePunctuation_70 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfMessage
syntax cluster asemeBodyOfMessage contains=asemeDeclaration_64,asemeBuiltIn_67,asemeType_69,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeType_69 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax match asemeBuiltIn_67 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax region asemeComment_68 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax match asemeComment_68 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax match asemeName_66 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeDeclaration_64 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_61,asemeType_63,asemeComment_65 skipwhite skipempty
syntax region asemeComment_65 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_61,asemeType_63,asemeComment_65 skipwhite skipempty
syntax match asemeComment_65 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_61,asemeType_63,asemeComment_65 skipwhite skipempty
syntax match asemeType_63 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax match asemeBuiltIn_61 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax region asemeComment_62 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax match asemeComment_62 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax match asemeName_60 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_52,asemePunctuation_54,asemeBuiltIn_56,asemeType_58,asemeName_59
syntax match asemeName_59 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeType_58 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=asemeName_55,asemeComment_57 skipwhite skipempty
syntax match asemeBuiltIn_56 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=asemeName_55,asemeComment_57 skipwhite skipempty
syntax region asemeComment_57 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_55,asemeComment_57 skipwhite skipempty
syntax match asemeComment_57 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_55,asemeComment_57 skipwhite skipempty
syntax match asemeName_55 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemePunctuation_54 /\v[;,]/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeOperator_52 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_50,asemeComment_53 skipwhite skipempty
syntax region asemeComment_53 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_50,asemeComment_53 skipwhite skipempty
syntax match asemeComment_53 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_50,asemeComment_53 skipwhite skipempty
syntax match asemeNumber_50 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax region asemeComment_51 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeComment_51 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeDeclaration_48 /\v%(enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=enum%(<|>)/ nextgroup=asemeBlock_47,asemeComment_49 skipwhite skipempty
syntax region asemeComment_49 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_47,asemeComment_49 skipwhite skipempty
syntax match asemeComment_49 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_47,asemeComment_49 skipwhite skipempty
syntax match asemeBlock_47 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_46 skipwhite skipempty
syntax cluster asemeEnumInFile contains=asemePunctuation_44,asemeBlock_45
syntax match asemeBlock_45 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeEnumInFile,asemeComment_46 skipwhite skipempty
syntax region asemeComment_46 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_46 skipwhite skipempty
syntax match asemeComment_46 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumInFile,asemeComment_46 skipwhite skipempty
syntax region asemePunctuation_44 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfEnum
syntax cluster asemeBodyOfEnum contains=asemeName_37,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_37 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_33 skipwhite skipempty
syntax cluster asemeEnumConstantInBodyOfEnum contains=asemeOperator_34,asemePunctuation_36
syntax match asemePunctuation_36 /\v[;,]/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_33 skipwhite skipempty
syntax match asemeOperator_34 /\v\=%(\=)@!/ contained nextgroup=asemeNumber_32,asemeComment_35 skipwhite skipempty
syntax region asemeComment_35 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_32,asemeComment_35 skipwhite skipempty
syntax match asemeComment_35 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_32,asemeComment_35 skipwhite skipempty
syntax match asemeNumber_32 /\v\-?\_s*[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_33 skipwhite skipempty
syntax region asemeComment_33 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_33 skipwhite skipempty
syntax match asemeComment_33 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeEnumConstantInBodyOfEnum,asemeComment_33 skipwhite skipempty
syntax match asemeDeclaration_30 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ nextgroup=asemeName_28,asemeComment_31 skipwhite skipempty
syntax region asemeComment_31 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_28,asemeComment_31 skipwhite skipempty
syntax match asemeComment_31 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_28,asemeComment_31 skipwhite skipempty
syntax match asemeName_28 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_27,asemeComment_29 skipwhite skipempty
syntax region asemeComment_29 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_27,asemeComment_29 skipwhite skipempty
syntax match asemeComment_29 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_27,asemeComment_29 skipwhite skipempty
syntax match asemeOperator_27 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax cluster asemeLet contains=asemeText_10,asemeNumber_12,asemeTruth_13,asemeLogic_14,asemeClause_15,asemeClause_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeCall_23,asemeReference_24,asemeOperator_25,asemePunctuation_26
syntax match asemePunctuation_26 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeOperator_25 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeReference_24 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeCall_23 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_22 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_21 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_20 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_19 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_18 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_17 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_16 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_15 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeLogic_14 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeTruth_13 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeNumber_12 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeText_10 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax region asemeComment_11 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeComment_11 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
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
highlight default link asemeBlock_100 asemeBlock
highlight default link asemeBlock_148 asemeBlock
highlight default link asemeBlock_150 asemeBlock
highlight default link asemeBlock_282 asemeBlock
highlight default link asemeBlock_283 asemeBlock
highlight default link asemeBlock_378 asemeBlock
highlight default link asemeBlock_380 asemeBlock
highlight default link asemeBlock_384 asemeBlock
highlight default link asemeBlock_386 asemeBlock
highlight default link asemeBlock_389 asemeBlock
highlight default link asemeBlock_45 asemeBlock
highlight default link asemeBlock_47 asemeBlock
highlight default link asemeBlock_584 asemeBlock
highlight default link asemeBlock_586 asemeBlock
highlight default link asemeBlock_589 asemeBlock
highlight default link asemeBlock_591 asemeBlock
highlight default link asemeBlock_595 asemeBlock
highlight default link asemeBlock_596 asemeBlock
highlight default link asemeBlock_601 asemeBlock
highlight default link asemeBlock_667 asemeBlock
highlight default link asemeBlock_669 asemeBlock
highlight default link asemeBlock_690 asemeBlock
highlight default link asemeBlock_692 asemeBlock
highlight default link asemeBlock_71 asemeBlock
highlight default link asemeBlock_73 asemeBlock
highlight default link asemeBlock_99 asemeBlock
highlight default link asemeBuiltIn_107 asemeBuiltIn
highlight default link asemeBuiltIn_115 asemeBuiltIn
highlight default link asemeBuiltIn_122 asemeBuiltIn
highlight default link asemeBuiltIn_199 asemeBuiltIn
highlight default link asemeBuiltIn_222 asemeBuiltIn
highlight default link asemeBuiltIn_228 asemeBuiltIn
highlight default link asemeBuiltIn_230 asemeBuiltIn
highlight default link asemeBuiltIn_453 asemeBuiltIn
highlight default link asemeBuiltIn_459 asemeBuiltIn
highlight default link asemeBuiltIn_465 asemeBuiltIn
highlight default link asemeBuiltIn_467 asemeBuiltIn
highlight default link asemeBuiltIn_56 asemeBuiltIn
highlight default link asemeBuiltIn_61 asemeBuiltIn
highlight default link asemeBuiltIn_635 asemeBuiltIn
highlight default link asemeBuiltIn_641 asemeBuiltIn
highlight default link asemeBuiltIn_647 asemeBuiltIn
highlight default link asemeBuiltIn_649 asemeBuiltIn
highlight default link asemeBuiltIn_67 asemeBuiltIn
highlight default link asemeCall_217 asemeCall
highlight default link asemeCall_23 asemeCall
highlight default link asemeCall_341 asemeCall
highlight default link asemeCall_366 asemeCall
highlight default link asemeChoice_160 asemeChoice
highlight default link asemeChoice_289 asemeChoice
highlight default link asemeChoice_495 asemeChoice
highlight default link asemeChoice_509 asemeChoice
highlight default link asemeChoice_525 asemeChoice
highlight default link asemeChoice_537 asemeChoice
highlight default link asemeChoice_551 asemeChoice
highlight default link asemeChoice_567 asemeChoice
highlight default link asemeChoice_610 asemeChoice
highlight default link asemeChoice_614 asemeChoice
highlight default link asemeChoice_622 asemeChoice
highlight default link asemeChoice_90 asemeChoice
highlight default link asemeClause_135 asemeClause
highlight default link asemeClause_137 asemeClause
highlight default link asemeClause_15 asemeClause
highlight default link asemeClause_16 asemeClause
highlight default link asemeClause_169 asemeClause
highlight default link asemeClause_17 asemeClause
highlight default link asemeClause_172 asemeClause
highlight default link asemeClause_175 asemeClause
highlight default link asemeClause_18 asemeClause
highlight default link asemeClause_19 asemeClause
highlight default link asemeClause_20 asemeClause
highlight default link asemeClause_209 asemeClause
highlight default link asemeClause_21 asemeClause
highlight default link asemeClause_210 asemeClause
highlight default link asemeClause_211 asemeClause
highlight default link asemeClause_212 asemeClause
highlight default link asemeClause_213 asemeClause
highlight default link asemeClause_214 asemeClause
highlight default link asemeClause_215 asemeClause
highlight default link asemeClause_216 asemeClause
highlight default link asemeClause_22 asemeClause
highlight default link asemeClause_292 asemeClause
highlight default link asemeClause_294 asemeClause
highlight default link asemeClause_297 asemeClause
highlight default link asemeClause_299 asemeClause
highlight default link asemeClause_300 asemeClause
highlight default link asemeClause_303 asemeClause
highlight default link asemeClause_305 asemeClause
highlight default link asemeClause_306 asemeClause
highlight default link asemeClause_323 asemeClause
highlight default link asemeClause_333 asemeClause
highlight default link asemeClause_334 asemeClause
highlight default link asemeClause_335 asemeClause
highlight default link asemeClause_336 asemeClause
highlight default link asemeClause_337 asemeClause
highlight default link asemeClause_338 asemeClause
highlight default link asemeClause_339 asemeClause
highlight default link asemeClause_340 asemeClause
highlight default link asemeClause_358 asemeClause
highlight default link asemeClause_359 asemeClause
highlight default link asemeClause_360 asemeClause
highlight default link asemeClause_361 asemeClause
highlight default link asemeClause_362 asemeClause
highlight default link asemeClause_363 asemeClause
highlight default link asemeClause_364 asemeClause
highlight default link asemeClause_365 asemeClause
highlight default link asemeClause_391 asemeClause
highlight default link asemeClause_407 asemeClause
highlight default link asemeClause_410 asemeClause
highlight default link asemeClause_498 asemeClause
highlight default link asemeClause_501 asemeClause
highlight default link asemeClause_504 asemeClause
highlight default link asemeClause_507 asemeClause
highlight default link asemeClause_510 asemeClause
highlight default link asemeClause_513 asemeClause
highlight default link asemeClause_516 asemeClause
highlight default link asemeClause_519 asemeClause
highlight default link asemeClause_522 asemeClause
highlight default link asemeClause_540 asemeClause
highlight default link asemeClause_543 asemeClause
highlight default link asemeClause_546 asemeClause
highlight default link asemeClause_549 asemeClause
highlight default link asemeClause_552 asemeClause
highlight default link asemeClause_555 asemeClause
highlight default link asemeClause_558 asemeClause
highlight default link asemeClause_561 asemeClause
highlight default link asemeClause_564 asemeClause
highlight default link asemeClause_597 asemeClause
highlight default link asemeClause_606 asemeClause
highlight default link asemeClause_78 asemeClause
highlight default link asemeClause_81 asemeClause
highlight default link asemeClause_85 asemeClause
highlight default link asemeClause_88 asemeClause
highlight default link asemeComment_102 asemeComment
highlight default link asemeComment_104 asemeComment
highlight default link asemeComment_106 asemeComment
highlight default link asemeComment_108 asemeComment
highlight default link asemeComment_11 asemeComment
highlight default link asemeComment_111 asemeComment
highlight default link asemeComment_113 asemeComment
highlight default link asemeComment_116 asemeComment
highlight default link asemeComment_119 asemeComment
highlight default link asemeComment_123 asemeComment
highlight default link asemeComment_127 asemeComment
highlight default link asemeComment_130 asemeComment
highlight default link asemeComment_132 asemeComment
highlight default link asemeComment_134 asemeComment
highlight default link asemeComment_136 asemeComment
highlight default link asemeComment_138 asemeComment
highlight default link asemeComment_141 asemeComment
highlight default link asemeComment_146 asemeComment
highlight default link asemeComment_149 asemeComment
highlight default link asemeComment_152 asemeComment
highlight default link asemeComment_155 asemeComment
highlight default link asemeComment_157 asemeComment
highlight default link asemeComment_159 asemeComment
highlight default link asemeComment_162 asemeComment
highlight default link asemeComment_166 asemeComment
highlight default link asemeComment_168 asemeComment
highlight default link asemeComment_170 asemeComment
highlight default link asemeComment_173 asemeComment
highlight default link asemeComment_176 asemeComment
highlight default link asemeComment_179 asemeComment
highlight default link asemeComment_184 asemeComment
highlight default link asemeComment_187 asemeComment
highlight default link asemeComment_189 asemeComment
highlight default link asemeComment_191 asemeComment
highlight default link asemeComment_194 asemeComment
highlight default link asemeComment_198 asemeComment
highlight default link asemeComment_2 asemeComment
highlight default link asemeComment_200 asemeComment
highlight default link asemeComment_203 asemeComment
highlight default link asemeComment_205 asemeComment
highlight default link asemeComment_225 asemeComment
highlight default link asemeComment_227 asemeComment
highlight default link asemeComment_233 asemeComment
highlight default link asemeComment_235 asemeComment
highlight default link asemeComment_237 asemeComment
highlight default link asemeComment_240 asemeComment
highlight default link asemeComment_242 asemeComment
highlight default link asemeComment_244 asemeComment
highlight default link asemeComment_246 asemeComment
highlight default link asemeComment_248 asemeComment
highlight default link asemeComment_251 asemeComment
highlight default link asemeComment_254 asemeComment
highlight default link asemeComment_256 asemeComment
highlight default link asemeComment_258 asemeComment
highlight default link asemeComment_260 asemeComment
highlight default link asemeComment_262 asemeComment
highlight default link asemeComment_265 asemeComment
highlight default link asemeComment_268 asemeComment
highlight default link asemeComment_270 asemeComment
highlight default link asemeComment_272 asemeComment
highlight default link asemeComment_280 asemeComment
highlight default link asemeComment_285 asemeComment
highlight default link asemeComment_288 asemeComment
highlight default link asemeComment_29 asemeComment
highlight default link asemeComment_290 asemeComment
highlight default link asemeComment_293 asemeComment
highlight default link asemeComment_295 asemeComment
highlight default link asemeComment_298 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_304 asemeComment
highlight default link asemeComment_309 asemeComment
highlight default link asemeComment_31 asemeComment
highlight default link asemeComment_312 asemeComment
highlight default link asemeComment_318 asemeComment
highlight default link asemeComment_320 asemeComment
highlight default link asemeComment_322 asemeComment
highlight default link asemeComment_324 asemeComment
highlight default link asemeComment_327 asemeComment
highlight default link asemeComment_329 asemeComment
highlight default link asemeComment_33 asemeComment
highlight default link asemeComment_35 asemeComment
highlight default link asemeComment_354 asemeComment
highlight default link asemeComment_372 asemeComment
highlight default link asemeComment_374 asemeComment
highlight default link asemeComment_376 asemeComment
highlight default link asemeComment_379 asemeComment
highlight default link asemeComment_382 asemeComment
highlight default link asemeComment_385 asemeComment
highlight default link asemeComment_388 asemeComment
highlight default link asemeComment_390 asemeComment
highlight default link asemeComment_392 asemeComment
highlight default link asemeComment_394 asemeComment
highlight default link asemeComment_396 asemeComment
highlight default link asemeComment_400 asemeComment
highlight default link asemeComment_402 asemeComment
highlight default link asemeComment_404 asemeComment
highlight default link asemeComment_406 asemeComment
highlight default link asemeComment_408 asemeComment
highlight default link asemeComment_411 asemeComment
highlight default link asemeComment_414 asemeComment
highlight default link asemeComment_417 asemeComment
highlight default link asemeComment_419 asemeComment
highlight default link asemeComment_421 asemeComment
highlight default link asemeComment_424 asemeComment
highlight default link asemeComment_427 asemeComment
highlight default link asemeComment_429 asemeComment
highlight default link asemeComment_432 asemeComment
highlight default link asemeComment_434 asemeComment
highlight default link asemeComment_436 asemeComment
highlight default link asemeComment_438 asemeComment
highlight default link asemeComment_440 asemeComment
highlight default link asemeComment_443 asemeComment
highlight default link asemeComment_447 asemeComment
highlight default link asemeComment_450 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_454 asemeComment
highlight default link asemeComment_457 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_462 asemeComment
highlight default link asemeComment_464 asemeComment
highlight default link asemeComment_470 asemeComment
highlight default link asemeComment_472 asemeComment
highlight default link asemeComment_474 asemeComment
highlight default link asemeComment_477 asemeComment
highlight default link asemeComment_479 asemeComment
highlight default link asemeComment_481 asemeComment
highlight default link asemeComment_489 asemeComment
highlight default link asemeComment_49 asemeComment
highlight default link asemeComment_492 asemeComment
highlight default link asemeComment_494 asemeComment
highlight default link asemeComment_496 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_502 asemeComment
highlight default link asemeComment_505 asemeComment
highlight default link asemeComment_508 asemeComment
highlight default link asemeComment_51 asemeComment
highlight default link asemeComment_511 asemeComment
highlight default link asemeComment_514 asemeComment
highlight default link asemeComment_517 asemeComment
highlight default link asemeComment_520 asemeComment
highlight default link asemeComment_523 asemeComment
highlight default link asemeComment_526 asemeComment
highlight default link asemeComment_53 asemeComment
highlight default link asemeComment_530 asemeComment
highlight default link asemeComment_534 asemeComment
highlight default link asemeComment_536 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_544 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_550 asemeComment
highlight default link asemeComment_553 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_559 asemeComment
highlight default link asemeComment_562 asemeComment
highlight default link asemeComment_565 asemeComment
highlight default link asemeComment_568 asemeComment
highlight default link asemeComment_57 asemeComment
highlight default link asemeComment_572 asemeComment
highlight default link asemeComment_575 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_582 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_588 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_593 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_600 asemeComment
highlight default link asemeComment_603 asemeComment
highlight default link asemeComment_605 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_611 asemeComment
highlight default link asemeComment_615 asemeComment
highlight default link asemeComment_617 asemeComment
highlight default link asemeComment_62 asemeComment
highlight default link asemeComment_623 asemeComment
highlight default link asemeComment_625 asemeComment
highlight default link asemeComment_627 asemeComment
highlight default link asemeComment_630 asemeComment
highlight default link asemeComment_632 asemeComment
highlight default link asemeComment_634 asemeComment
highlight default link asemeComment_636 asemeComment
highlight default link asemeComment_639 asemeComment
highlight default link asemeComment_644 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_654 asemeComment
highlight default link asemeComment_656 asemeComment
highlight default link asemeComment_659 asemeComment
highlight default link asemeComment_661 asemeComment
highlight default link asemeComment_663 asemeComment
highlight default link asemeComment_665 asemeComment
highlight default link asemeComment_668 asemeComment
highlight default link asemeComment_671 asemeComment
highlight default link asemeComment_673 asemeComment
highlight default link asemeComment_675 asemeComment
highlight default link asemeComment_677 asemeComment
highlight default link asemeComment_679 asemeComment
highlight default link asemeComment_68 asemeComment
highlight default link asemeComment_681 asemeComment
highlight default link asemeComment_684 asemeComment
highlight default link asemeComment_687 asemeComment
highlight default link asemeComment_691 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_72 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_723 asemeComment
highlight default link asemeComment_731 asemeComment
highlight default link asemeComment_734 asemeComment
highlight default link asemeComment_75 asemeComment
highlight default link asemeComment_77 asemeComment
highlight default link asemeComment_79 asemeComment
highlight default link asemeComment_82 asemeComment
highlight default link asemeComment_84 asemeComment
highlight default link asemeComment_86 asemeComment
highlight default link asemeComment_89 asemeComment
highlight default link asemeComment_9 asemeComment
highlight default link asemeComment_93 asemeComment
highlight default link asemeComment_97 asemeComment
highlight default link asemeDeclaration_1 asemeDeclaration
highlight default link asemeDeclaration_101 asemeDeclaration
highlight default link asemeDeclaration_131 asemeDeclaration
highlight default link asemeDeclaration_145 asemeDeclaration
highlight default link asemeDeclaration_151 asemeDeclaration
highlight default link asemeDeclaration_154 asemeDeclaration
highlight default link asemeDeclaration_165 asemeDeclaration
highlight default link asemeDeclaration_183 asemeDeclaration
highlight default link asemeDeclaration_186 asemeDeclaration
highlight default link asemeDeclaration_197 asemeDeclaration
highlight default link asemeDeclaration_236 asemeDeclaration
highlight default link asemeDeclaration_241 asemeDeclaration
highlight default link asemeDeclaration_255 asemeDeclaration
highlight default link asemeDeclaration_269 asemeDeclaration
highlight default link asemeDeclaration_284 asemeDeclaration
highlight default link asemeDeclaration_287 asemeDeclaration
highlight default link asemeDeclaration_30 asemeDeclaration
highlight default link asemeDeclaration_315 asemeDeclaration
highlight default link asemeDeclaration_319 asemeDeclaration
highlight default link asemeDeclaration_352 asemeDeclaration
highlight default link asemeDeclaration_381 asemeDeclaration
highlight default link asemeDeclaration_387 asemeDeclaration
highlight default link asemeDeclaration_399 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_435 asemeDeclaration
highlight default link asemeDeclaration_451 asemeDeclaration
highlight default link asemeDeclaration_473 asemeDeclaration
highlight default link asemeDeclaration_478 asemeDeclaration
highlight default link asemeDeclaration_48 asemeDeclaration
highlight default link asemeDeclaration_491 asemeDeclaration
highlight default link asemeDeclaration_533 asemeDeclaration
highlight default link asemeDeclaration_578 asemeDeclaration
highlight default link asemeDeclaration_581 asemeDeclaration
highlight default link asemeDeclaration_587 asemeDeclaration
highlight default link asemeDeclaration_592 asemeDeclaration
highlight default link asemeDeclaration_599 asemeDeclaration
highlight default link asemeDeclaration_602 asemeDeclaration
highlight default link asemeDeclaration_626 asemeDeclaration
highlight default link asemeDeclaration_64 asemeDeclaration
highlight default link asemeDeclaration_655 asemeDeclaration
highlight default link asemeDeclaration_660 asemeDeclaration
highlight default link asemeDeclaration_662 asemeDeclaration
highlight default link asemeDeclaration_664 asemeDeclaration
highlight default link asemeDeclaration_670 asemeDeclaration
highlight default link asemeDeclaration_693 asemeDeclaration
highlight default link asemeDeclaration_722 asemeDeclaration
highlight default link asemeDeclaration_733 asemeDeclaration
highlight default link asemeDeclaration_74 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_96 asemeDeclaration
highlight default link asemeLogic_14 asemeLogic
highlight default link asemeLogic_208 asemeLogic
highlight default link asemeLogic_332 asemeLogic
highlight default link asemeLogic_357 asemeLogic
highlight default link asemeName_114 asemeName
highlight default link asemeName_121 asemeName
highlight default link asemeName_126 asemeName
highlight default link asemeName_129 asemeName
highlight default link asemeName_143 asemeName
highlight default link asemeName_144 asemeName
highlight default link asemeName_181 asemeName
highlight default link asemeName_182 asemeName
highlight default link asemeName_226 asemeName
highlight default link asemeName_234 asemeName
highlight default link asemeName_239 asemeName
highlight default link asemeName_279 asemeName
highlight default link asemeName_28 asemeName
highlight default link asemeName_296 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_307 asemeName
highlight default link asemeName_314 asemeName
highlight default link asemeName_317 asemeName
highlight default link asemeName_37 asemeName
highlight default link asemeName_446 asemeName
highlight default link asemeName_449 asemeName
highlight default link asemeName_463 asemeName
highlight default link asemeName_471 asemeName
highlight default link asemeName_476 asemeName
highlight default link asemeName_488 asemeName
highlight default link asemeName_531 asemeName
highlight default link asemeName_55 asemeName
highlight default link asemeName_576 asemeName
highlight default link asemeName_59 asemeName
highlight default link asemeName_60 asemeName
highlight default link asemeName_608 asemeName
highlight default link asemeName_612 asemeName
highlight default link asemeName_618 asemeName
highlight default link asemeName_620 asemeName
highlight default link asemeName_645 asemeName
highlight default link asemeName_653 asemeName
highlight default link asemeName_658 asemeName
highlight default link asemeName_66 asemeName
highlight default link asemeName_682 asemeName
highlight default link asemeName_688 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_12 asemeNumber
highlight default link asemeNumber_188 asemeNumber
highlight default link asemeNumber_192 asemeNumber
highlight default link asemeNumber_206 asemeNumber
highlight default link asemeNumber_273 asemeNumber
highlight default link asemeNumber_275 asemeNumber
highlight default link asemeNumber_291 asemeNumber
highlight default link asemeNumber_302 asemeNumber
highlight default link asemeNumber_32 asemeNumber
highlight default link asemeNumber_321 asemeNumber
highlight default link asemeNumber_325 asemeNumber
highlight default link asemeNumber_330 asemeNumber
highlight default link asemeNumber_347 asemeNumber
highlight default link asemeNumber_349 asemeNumber
highlight default link asemeNumber_355 asemeNumber
highlight default link asemeNumber_371 asemeNumber
highlight default link asemeNumber_375 asemeNumber
highlight default link asemeNumber_40 asemeNumber
highlight default link asemeNumber_482 asemeNumber
highlight default link asemeNumber_484 asemeNumber
highlight default link asemeNumber_50 asemeNumber
highlight default link asemeNumber_500 asemeNumber
highlight default link asemeNumber_503 asemeNumber
highlight default link asemeNumber_506 asemeNumber
highlight default link asemeNumber_515 asemeNumber
highlight default link asemeNumber_542 asemeNumber
highlight default link asemeNumber_545 asemeNumber
highlight default link asemeNumber_548 asemeNumber
highlight default link asemeNumber_557 asemeNumber
highlight default link asemeNumber_616 asemeNumber
highlight default link asemeNumber_624 asemeNumber
highlight default link asemeNumber_629 asemeNumber
highlight default link asemeNumber_633 asemeNumber
highlight default link asemeNumber_674 asemeNumber
highlight default link asemeNumber_678 asemeNumber
highlight default link asemeNumber_696 asemeNumber
highlight default link asemeNumber_702 asemeNumber
highlight default link asemeNumber_708 asemeNumber
highlight default link asemeNumber_714 asemeNumber
highlight default link asemeNumber_725 asemeNumber
highlight default link asemeNumber_737 asemeNumber
highlight default link asemeNumber_80 asemeNumber
highlight default link asemeNumber_87 asemeNumber
highlight default link asemeOperator_105 asemeOperator
highlight default link asemeOperator_219 asemeOperator
highlight default link asemeOperator_221 asemeOperator
highlight default link asemeOperator_238 asemeOperator
highlight default link asemeOperator_25 asemeOperator
highlight default link asemeOperator_27 asemeOperator
highlight default link asemeOperator_276 asemeOperator
highlight default link asemeOperator_278 asemeOperator
highlight default link asemeOperator_311 asemeOperator
highlight default link asemeOperator_316 asemeOperator
highlight default link asemeOperator_326 asemeOperator
highlight default link asemeOperator_34 asemeOperator
highlight default link asemeOperator_343 asemeOperator
highlight default link asemeOperator_350 asemeOperator
highlight default link asemeOperator_368 asemeOperator
highlight default link asemeOperator_373 asemeOperator
highlight default link asemeOperator_403 asemeOperator
highlight default link asemeOperator_413 asemeOperator
highlight default link asemeOperator_439 asemeOperator
highlight default link asemeOperator_458 asemeOperator
highlight default link asemeOperator_475 asemeOperator
highlight default link asemeOperator_485 asemeOperator
highlight default link asemeOperator_487 asemeOperator
highlight default link asemeOperator_52 asemeOperator
highlight default link asemeOperator_574 asemeOperator
highlight default link asemeOperator_631 asemeOperator
highlight default link asemeOperator_640 asemeOperator
highlight default link asemeOperator_657 asemeOperator
highlight default link asemeOperator_698 asemeOperator
highlight default link asemeOperator_704 asemeOperator
highlight default link asemeOperator_710 asemeOperator
highlight default link asemeOperator_716 asemeOperator
highlight default link asemeOperator_727 asemeOperator
highlight default link asemePunctuation_110 asemePunctuation
highlight default link asemePunctuation_112 asemePunctuation
highlight default link asemePunctuation_118 asemePunctuation
highlight default link asemePunctuation_120 asemePunctuation
highlight default link asemePunctuation_125 asemePunctuation
highlight default link asemePunctuation_128 asemePunctuation
highlight default link asemePunctuation_140 asemePunctuation
highlight default link asemePunctuation_147 asemePunctuation
highlight default link asemePunctuation_153 asemePunctuation
highlight default link asemePunctuation_158 asemePunctuation
highlight default link asemePunctuation_161 asemePunctuation
highlight default link asemePunctuation_178 asemePunctuation
highlight default link asemePunctuation_185 asemePunctuation
highlight default link asemePunctuation_190 asemePunctuation
highlight default link asemePunctuation_193 asemePunctuation
highlight default link asemePunctuation_195 asemePunctuation
highlight default link asemePunctuation_202 asemePunctuation
highlight default link asemePunctuation_220 asemePunctuation
highlight default link asemePunctuation_224 asemePunctuation
highlight default link asemePunctuation_232 asemePunctuation
highlight default link asemePunctuation_247 asemePunctuation
highlight default link asemePunctuation_26 asemePunctuation
highlight default link asemePunctuation_261 asemePunctuation
highlight default link asemePunctuation_277 asemePunctuation
highlight default link asemePunctuation_281 asemePunctuation
highlight default link asemePunctuation_308 asemePunctuation
highlight default link asemePunctuation_313 asemePunctuation
highlight default link asemePunctuation_344 asemePunctuation
highlight default link asemePunctuation_345 asemePunctuation
highlight default link asemePunctuation_351 asemePunctuation
highlight default link asemePunctuation_36 asemePunctuation
highlight default link asemePunctuation_369 asemePunctuation
highlight default link asemePunctuation_370 asemePunctuation
highlight default link asemePunctuation_377 asemePunctuation
highlight default link asemePunctuation_383 asemePunctuation
highlight default link asemePunctuation_395 asemePunctuation
highlight default link asemePunctuation_416 asemePunctuation
highlight default link asemePunctuation_420 asemePunctuation
highlight default link asemePunctuation_423 asemePunctuation
highlight default link asemePunctuation_426 asemePunctuation
highlight default link asemePunctuation_43 asemePunctuation
highlight default link asemePunctuation_431 asemePunctuation
highlight default link asemePunctuation_44 asemePunctuation
highlight default link asemePunctuation_442 asemePunctuation
highlight default link asemePunctuation_456 asemePunctuation
highlight default link asemePunctuation_461 asemePunctuation
highlight default link asemePunctuation_469 asemePunctuation
highlight default link asemePunctuation_486 asemePunctuation
highlight default link asemePunctuation_490 asemePunctuation
highlight default link asemePunctuation_529 asemePunctuation
highlight default link asemePunctuation_532 asemePunctuation
highlight default link asemePunctuation_54 asemePunctuation
highlight default link asemePunctuation_571 asemePunctuation
highlight default link asemePunctuation_577 asemePunctuation
highlight default link asemePunctuation_583 asemePunctuation
highlight default link asemePunctuation_594 asemePunctuation
highlight default link asemePunctuation_628 asemePunctuation
highlight default link asemePunctuation_638 asemePunctuation
highlight default link asemePunctuation_643 asemePunctuation
highlight default link asemePunctuation_651 asemePunctuation
highlight default link asemePunctuation_666 asemePunctuation
highlight default link asemePunctuation_672 asemePunctuation
highlight default link asemePunctuation_676 asemePunctuation
highlight default link asemePunctuation_680 asemePunctuation
highlight default link asemePunctuation_683 asemePunctuation
highlight default link asemePunctuation_686 asemePunctuation
highlight default link asemePunctuation_689 asemePunctuation
highlight default link asemePunctuation_699 asemePunctuation
highlight default link asemePunctuation_70 asemePunctuation
highlight default link asemePunctuation_700 asemePunctuation
highlight default link asemePunctuation_705 asemePunctuation
highlight default link asemePunctuation_706 asemePunctuation
highlight default link asemePunctuation_711 asemePunctuation
highlight default link asemePunctuation_712 asemePunctuation
highlight default link asemePunctuation_717 asemePunctuation
highlight default link asemePunctuation_718 asemePunctuation
highlight default link asemePunctuation_728 asemePunctuation
highlight default link asemePunctuation_729 asemePunctuation
highlight default link asemePunctuation_740 asemePunctuation
highlight default link asemePunctuation_92 asemePunctuation
highlight default link asemePunctuation_98 asemePunctuation
highlight default link asemeReference_133 asemeReference
highlight default link asemeReference_139 asemeReference
highlight default link asemeReference_156 asemeReference
highlight default link asemeReference_163 asemeReference
highlight default link asemeReference_164 asemeReference
highlight default link asemeReference_167 asemeReference
highlight default link asemeReference_171 asemeReference
highlight default link asemeReference_174 asemeReference
highlight default link asemeReference_177 asemeReference
highlight default link asemeReference_218 asemeReference
highlight default link asemeReference_24 asemeReference
highlight default link asemeReference_243 asemeReference
highlight default link asemeReference_245 asemeReference
highlight default link asemeReference_249 asemeReference
highlight default link asemeReference_250 asemeReference
highlight default link asemeReference_252 asemeReference
highlight default link asemeReference_253 asemeReference
highlight default link asemeReference_257 asemeReference
highlight default link asemeReference_259 asemeReference
highlight default link asemeReference_263 asemeReference
highlight default link asemeReference_264 asemeReference
highlight default link asemeReference_266 asemeReference
highlight default link asemeReference_267 asemeReference
highlight default link asemeReference_274 asemeReference
highlight default link asemeReference_310 asemeReference
highlight default link asemeReference_342 asemeReference
highlight default link asemeReference_348 asemeReference
highlight default link asemeReference_367 asemeReference
highlight default link asemeReference_393 asemeReference
highlight default link asemeReference_397 asemeReference
highlight default link asemeReference_398 asemeReference
highlight default link asemeReference_401 asemeReference
highlight default link asemeReference_405 asemeReference
highlight default link asemeReference_409 asemeReference
highlight default link asemeReference_41 asemeReference
highlight default link asemeReference_412 asemeReference
highlight default link asemeReference_415 asemeReference
highlight default link asemeReference_418 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_422 asemeReference
highlight default link asemeReference_425 asemeReference
highlight default link asemeReference_428 asemeReference
highlight default link asemeReference_430 asemeReference
highlight default link asemeReference_433 asemeReference
highlight default link asemeReference_437 asemeReference
highlight default link asemeReference_441 asemeReference
highlight default link asemeReference_483 asemeReference
highlight default link asemeReference_493 asemeReference
highlight default link asemeReference_497 asemeReference
highlight default link asemeReference_512 asemeReference
highlight default link asemeReference_518 asemeReference
highlight default link asemeReference_521 asemeReference
highlight default link asemeReference_524 asemeReference
highlight default link asemeReference_527 asemeReference
highlight default link asemeReference_528 asemeReference
highlight default link asemeReference_535 asemeReference
highlight default link asemeReference_539 asemeReference
highlight default link asemeReference_554 asemeReference
highlight default link asemeReference_560 asemeReference
highlight default link asemeReference_563 asemeReference
highlight default link asemeReference_566 asemeReference
highlight default link asemeReference_569 asemeReference
highlight default link asemeReference_570 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_604 asemeReference
highlight default link asemeReference_685 asemeReference
highlight default link asemeReference_697 asemeReference
highlight default link asemeReference_703 asemeReference
highlight default link asemeReference_709 asemeReference
highlight default link asemeReference_715 asemeReference
highlight default link asemeReference_726 asemeReference
highlight default link asemeReference_738 asemeReference
highlight default link asemeReference_739 asemeReference
highlight default link asemeReference_76 asemeReference
highlight default link asemeReference_83 asemeReference
highlight default link asemeReference_91 asemeReference
highlight default link asemeReference_94 asemeReference
highlight default link asemeReference_95 asemeReference
highlight default link asemeText_10 asemeText
highlight default link asemeText_103 asemeText
highlight default link asemeText_142 asemeText
highlight default link asemeText_180 asemeText
highlight default link asemeText_196 asemeText
highlight default link asemeText_204 asemeText
highlight default link asemeText_271 asemeText
highlight default link asemeText_286 asemeText
highlight default link asemeText_328 asemeText
highlight default link asemeText_346 asemeText
highlight default link asemeText_353 asemeText
highlight default link asemeText_38 asemeText
highlight default link asemeText_39 asemeText
highlight default link asemeText_444 asemeText
highlight default link asemeText_445 asemeText
highlight default link asemeText_448 asemeText
highlight default link asemeText_480 asemeText
highlight default link asemeText_573 asemeText
highlight default link asemeText_580 asemeText
highlight default link asemeText_609 asemeText
highlight default link asemeText_613 asemeText
highlight default link asemeText_619 asemeText
highlight default link asemeText_621 asemeText
highlight default link asemeText_695 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_701 asemeText
highlight default link asemeText_707 asemeText
highlight default link asemeText_713 asemeText
highlight default link asemeText_719 asemeText
highlight default link asemeText_721 asemeText
highlight default link asemeText_724 asemeText
highlight default link asemeText_730 asemeText
highlight default link asemeText_732 asemeText
highlight default link asemeText_735 asemeText
highlight default link asemeText_736 asemeText
highlight default link asemeTruth_13 asemeTruth
highlight default link asemeTruth_207 asemeTruth
highlight default link asemeTruth_331 asemeTruth
highlight default link asemeTruth_356 asemeTruth
highlight default link asemeType_109 asemeType
highlight default link asemeType_117 asemeType
highlight default link asemeType_124 asemeType
highlight default link asemeType_201 asemeType
highlight default link asemeType_223 asemeType
highlight default link asemeType_229 asemeType
highlight default link asemeType_231 asemeType
highlight default link asemeType_455 asemeType
highlight default link asemeType_460 asemeType
highlight default link asemeType_466 asemeType
highlight default link asemeType_468 asemeType
highlight default link asemeType_58 asemeType
highlight default link asemeType_63 asemeType
highlight default link asemeType_637 asemeType
highlight default link asemeType_642 asemeType
highlight default link asemeType_648 asemeType
highlight default link asemeType_650 asemeType
highlight default link asemeType_69 asemeType
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
