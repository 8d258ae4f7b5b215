" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
syntax sync fromstart
syntax match asemeReference_749 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_748 /\v\w+/
syntax match asemeNumber_747 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_746 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_745 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_750 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_745,asemeText_746,asemeNumber_747,asemeReference_748,asemeReference_749,asemePunctuation_750,asemeComment
syntax match asemeReference_42 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_41 /\v\w+/ contained
syntax match asemeNumber_40 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_39 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_38 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_43 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_30,asemeDeclaration_48,asemeDeclaration_74,asemeDeclaration_101,asemeDeclaration_131,asemeDeclaration_154,asemeDeclaration_186,asemeDeclaration_392,asemeDeclaration_609,asemeDeclaration_612,asemeDeclaration_680,asemeDeclaration_703,asemeDeclaration_732,asemeDeclaration_743,asemeText_745,asemeText_746,asemeNumber_747,asemeReference_748,asemeReference_749,asemePunctuation_750,asemeComment
syntax match asemeDeclaration_743 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_742,asemeComment_744 skipwhite skipempty
syntax region asemeComment_744 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_742,asemeComment_744 skipwhite skipempty
syntax match asemeComment_744 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_742,asemeComment_744 skipwhite skipempty
syntax match asemeText_742 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_741 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_739,asemeText_740
syntax match asemeText_740 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_741 skipwhite skipempty
syntax region asemeComment_741 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_741 skipwhite skipempty
syntax match asemeComment_741 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_741 skipwhite skipempty
syntax region asemePunctuation_739 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_722,asemeText_734,asemeNumber_735,asemeReference_736,asemeOperator_737,asemePunctuation_738,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_738 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_737 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_736 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_735 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_734 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_732 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_731,asemeComment_733 skipwhite skipempty
syntax region asemeComment_733 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_731,asemeComment_733 skipwhite skipempty
syntax match asemeComment_733 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_731,asemeComment_733 skipwhite skipempty
syntax match asemeText_731 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_730 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_728,asemeText_729
syntax match asemeText_729 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_730 skipwhite skipempty
syntax region asemeComment_730 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_730 skipwhite skipempty
syntax match asemeComment_730 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_730 skipwhite skipempty
syntax region asemePunctuation_728 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_722,asemeText_723,asemeNumber_724,asemeReference_725,asemeOperator_726,asemePunctuation_727,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_727 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_726 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_725 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_724 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_723 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_722 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_716,asemeText_717,asemeNumber_718,asemeReference_719,asemeOperator_720,asemePunctuation_721,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_721 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_720 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_719 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_718 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_717 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_716 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_710,asemeText_711,asemeNumber_712,asemeReference_713,asemeOperator_714,asemePunctuation_715,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_715 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_714 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_713 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_712 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_711 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_710 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_705,asemeNumber_706,asemeReference_707,asemeOperator_708,asemePunctuation_709,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_709 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_708 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_707 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_706 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_705 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_703 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_702,asemeComment_704 skipwhite skipempty
syntax region asemeComment_704 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_702,asemeComment_704 skipwhite skipempty
syntax match asemeComment_704 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_702,asemeComment_704 skipwhite skipempty
syntax match asemeBlock_702 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_701 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_699,asemeBlock_700
syntax match asemeBlock_700 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_701 skipwhite skipempty
syntax region asemeComment_701 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_701 skipwhite skipempty
syntax match asemeComment_701 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_701 skipwhite skipempty
syntax region asemePunctuation_699 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_698,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_698 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_683 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemePunctuation_690,asemePunctuation_693,asemePunctuation_696
syntax match asemePunctuation_696 /\v\:/ contained nextgroup=asemeReference_695,asemeComment_697 skipwhite skipempty
syntax region asemeComment_697 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_695,asemeComment_697 skipwhite skipempty
syntax match asemeComment_697 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_695,asemeComment_697 skipwhite skipempty
syntax match asemeReference_695 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_683 skipwhite skipempty
syntax match asemePunctuation_693 /\v\,/ contained nextgroup=asemeName_692,asemeComment_694 skipwhite skipempty
syntax region asemeComment_694 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_692,asemeComment_694 skipwhite skipempty
syntax match asemeComment_694 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_692,asemeComment_694 skipwhite skipempty
syntax match asemeName_692 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_683 skipwhite skipempty
syntax match asemePunctuation_690 /\v\[/ contained nextgroup=asemeNumber_688,asemeComment_691 skipwhite skipempty
syntax region asemeComment_691 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_688,asemeComment_691 skipwhite skipempty
syntax match asemeComment_691 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_688,asemeComment_691 skipwhite skipempty
syntax match asemeNumber_688 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_686,asemeComment_689 skipwhite skipempty
syntax region asemeComment_689 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_686,asemeComment_689 skipwhite skipempty
syntax match asemeComment_689 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_686,asemeComment_689 skipwhite skipempty
syntax match asemePunctuation_686 /\v\.\./ contained nextgroup=asemeNumber_684,asemeComment_687 skipwhite skipempty
syntax region asemeComment_687 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_684,asemeComment_687 skipwhite skipempty
syntax match asemeComment_687 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_684,asemeComment_687 skipwhite skipempty
syntax match asemeNumber_684 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_682,asemeComment_685 skipwhite skipempty
syntax region asemeComment_685 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_682,asemeComment_685 skipwhite skipempty
syntax match asemeComment_685 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_682,asemeComment_685 skipwhite skipempty
syntax match asemePunctuation_682 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_683 skipwhite skipempty
syntax region asemeComment_683 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_683 skipwhite skipempty
syntax match asemeComment_683 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_683 skipwhite skipempty
syntax match asemeDeclaration_680 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_679,asemeComment_681 skipwhite skipempty
syntax region asemeComment_681 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_679,asemeComment_681 skipwhite skipempty
syntax match asemeComment_681 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_679,asemeComment_681 skipwhite skipempty
syntax match asemeBlock_679 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_678 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_676,asemeBlock_677
syntax match asemeBlock_677 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_678 skipwhite skipempty
syntax region asemeComment_678 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_678 skipwhite skipempty
syntax match asemeComment_678 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_678 skipwhite skipempty
syntax region asemePunctuation_676 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_636,asemeNumber_643,asemeDeclaration_665,asemeDeclaration_670,asemeDeclaration_672,asemeDeclaration_674,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_674 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_675 skipwhite skipempty
syntax region asemeComment_675 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_675 skipwhite skipempty
syntax match asemeComment_675 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_675 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_582
syntax match asemeDeclaration_672 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_673 skipwhite skipempty
syntax region asemeComment_673 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_673 skipwhite skipempty
syntax match asemeComment_673 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_673 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_537
syntax match asemeDeclaration_670 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_668,asemeComment_671 skipwhite skipempty
syntax region asemeComment_671 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_668,asemeComment_671 skipwhite skipempty
syntax match asemeComment_671 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_668,asemeComment_671 skipwhite skipempty
syntax match asemeName_668 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_667,asemeComment_669 skipwhite skipempty
syntax region asemeComment_669 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_667,asemeComment_669 skipwhite skipempty
syntax match asemeComment_669 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_667,asemeComment_669 skipwhite skipempty
syntax match asemeOperator_667 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_665 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_663,asemeComment_666 skipwhite skipempty
syntax region asemeComment_666 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_663,asemeComment_666 skipwhite skipempty
syntax match asemeComment_666 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_663,asemeComment_666 skipwhite skipempty
syntax match asemeName_663 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_661,asemeComment_664 skipwhite skipempty
syntax region asemeComment_664 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_661,asemeComment_664 skipwhite skipempty
syntax match asemeComment_664 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_661,asemeComment_664 skipwhite skipempty
syntax match asemePunctuation_661 /\v\:/ contained nextgroup=asemeBuiltIn_659,asemeType_660,asemeComment_662 skipwhite skipempty
syntax region asemeComment_662 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_659,asemeType_660,asemeComment_662 skipwhite skipempty
syntax match asemeComment_662 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_659,asemeType_660,asemeComment_662 skipwhite skipempty
syntax match asemeType_660 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeBuiltIn_659 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_648,asemeOperator_650,asemeName_655,asemeBuiltIn_657,asemeType_658
syntax match asemeType_658 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeBuiltIn_657 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeName_655 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_653,asemeComment_656 skipwhite skipempty
syntax region asemeComment_656 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_653,asemeComment_656 skipwhite skipempty
syntax match asemeComment_656 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_653,asemeComment_656 skipwhite skipempty
syntax match asemePunctuation_653 /\v\:/ contained nextgroup=asemeBuiltIn_651,asemeType_652,asemeComment_654 skipwhite skipempty
syntax region asemeComment_654 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_651,asemeType_652,asemeComment_654 skipwhite skipempty
syntax match asemeComment_654 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_651,asemeType_652,asemeComment_654 skipwhite skipempty
syntax match asemeType_652 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeBuiltIn_651 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeOperator_650 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_648 /\v\:/ contained nextgroup=asemeBuiltIn_645,asemeType_647,asemeComment_649 skipwhite skipempty
syntax region asemeComment_649 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_645,asemeType_647,asemeComment_649 skipwhite skipempty
syntax match asemeComment_649 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_645,asemeType_647,asemeComment_649 skipwhite skipempty
syntax match asemeType_647 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeBuiltIn_645 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax region asemeComment_646 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeComment_646 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_646 skipwhite skipempty
syntax match asemeNumber_643 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_641,asemeComment_644 skipwhite skipempty
syntax region asemeComment_644 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_641,asemeComment_644 skipwhite skipempty
syntax match asemeComment_644 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_641,asemeComment_644 skipwhite skipempty
syntax match asemeOperator_641 /\v\-\>/ contained nextgroup=asemeNumber_639,asemeComment_642 skipwhite skipempty
syntax region asemeComment_642 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_639,asemeComment_642 skipwhite skipempty
syntax match asemeComment_642 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_639,asemeComment_642 skipwhite skipempty
syntax match asemeNumber_639 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_638,asemeComment_640 skipwhite skipempty
syntax region asemeComment_640 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_638,asemeComment_640 skipwhite skipempty
syntax match asemeComment_640 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_638,asemeComment_640 skipwhite skipempty
syntax match asemePunctuation_638 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_354 skipwhite skipempty
syntax match asemeDeclaration_636 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_634,asemeComment_637 skipwhite skipempty
syntax region asemeComment_637 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_634,asemeComment_637 skipwhite skipempty
syntax match asemeComment_637 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_634,asemeComment_637 skipwhite skipempty
syntax match asemeNumber_634 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_632,asemeComment_635 skipwhite skipempty
syntax region asemeComment_635 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_632,asemeComment_635 skipwhite skipempty
syntax match asemeComment_635 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_632,asemeComment_635 skipwhite skipempty
syntax match asemeChoice_632 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_630,asemeText_631,@asemeChartNodeInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax region asemeComment_633 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_630,asemeText_631,@asemeChartNodeInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeComment_633 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_630,asemeText_631,@asemeChartNodeInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeText_631 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeName_630 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_616,asemeChoice_620,asemeNumber_626,asemeName_628,asemeText_629
syntax match asemeText_629 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeName_628 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeNumber_626 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_624,asemeComment_627 skipwhite skipempty
syntax region asemeComment_627 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_624,asemeComment_627 skipwhite skipempty
syntax match asemeComment_627 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_624,asemeComment_627 skipwhite skipempty
syntax match asemeChoice_624 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_622,asemeText_623,@asemeChartNodeInBodyOfStatechart,asemeComment_625 skipwhite skipempty
syntax region asemeComment_625 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_622,asemeText_623,@asemeChartNodeInBodyOfStatechart,asemeComment_625 skipwhite skipempty
syntax match asemeComment_625 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_622,asemeText_623,@asemeChartNodeInBodyOfStatechart,asemeComment_625 skipwhite skipempty
syntax match asemeText_623 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeName_622 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeChoice_620 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_618,asemeText_619,@asemeChartNodeInBodyOfStatechart,asemeComment_621 skipwhite skipempty
syntax region asemeComment_621 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_618,asemeText_619,@asemeChartNodeInBodyOfStatechart,asemeComment_621 skipwhite skipempty
syntax match asemeComment_621 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_618,asemeText_619,@asemeChartNodeInBodyOfStatechart,asemeComment_621 skipwhite skipempty
syntax match asemeText_619 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeName_618 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeClause_616 /\vactivity%(<|>)/ contained nextgroup=asemeReference_614,asemeComment_617 skipwhite skipempty
syntax region asemeComment_617 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_614,asemeComment_617 skipwhite skipempty
syntax match asemeComment_617 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_614,asemeComment_617 skipwhite skipempty
syntax match asemeReference_614 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax region asemeComment_615 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeComment_615 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_615 skipwhite skipempty
syntax match asemeDeclaration_612 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_611,asemeComment_613 skipwhite skipempty
syntax region asemeComment_613 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_611,asemeComment_613 skipwhite skipempty
syntax match asemeComment_613 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_611,asemeComment_613 skipwhite skipempty
syntax match asemeBlock_611 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_395 skipwhite skipempty
syntax match asemeDeclaration_609 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_607,asemeComment_610 skipwhite skipempty
syntax region asemeComment_610 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_607,asemeComment_610 skipwhite skipempty
syntax match asemeComment_610 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_607,asemeComment_610 skipwhite skipempty
syntax match asemeClause_607 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_606,asemeComment_608 skipwhite skipempty
syntax region asemeComment_608 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_606,asemeComment_608 skipwhite skipempty
syntax match asemeComment_608 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_606,asemeComment_608 skipwhite skipempty
syntax match asemeBlock_606 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_395 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_396,asemePunctuation_604,asemeBlock_605
syntax match asemeBlock_605 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_395 skipwhite skipempty
syntax region asemePunctuation_604 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_404,asemeDeclaration_440,asemeDeclaration_456,asemeDeclaration_478,asemeDeclaration_483,asemeDeclaration_496,asemeDeclaration_538,asemeDeclaration_583,asemeDeclaration_592,asemeDeclaration_602,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_602 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_600,asemeComment_603 skipwhite skipempty
syntax region asemeComment_603 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_600,asemeComment_603 skipwhite skipempty
syntax match asemeComment_603 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_600,asemeComment_603 skipwhite skipempty
syntax match asemeBlock_600 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_599,@asemeControlInBodyOfSrm,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_599,@asemeControlInBodyOfSrm,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_599,@asemeControlInBodyOfSrm,asemeComment_601 skipwhite skipempty
syntax match asemeOperator_599 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_595 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_377,asemeOperator_594,asemeBlock_597
syntax match asemeBlock_597 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_596,@asemeControlInBodyOfSrm,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_596,@asemeControlInBodyOfSrm,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_596,@asemeControlInBodyOfSrm,asemeComment_598 skipwhite skipempty
syntax match asemeOperator_596 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_595 skipwhite skipempty
syntax match asemeOperator_594 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_595 skipwhite skipempty
syntax region asemeComment_595 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_595 skipwhite skipempty
syntax match asemeComment_595 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_595 skipwhite skipempty
syntax match asemeDeclaration_592 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_591,asemeComment_593 skipwhite skipempty
syntax region asemeComment_593 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_591,asemeComment_593 skipwhite skipempty
syntax match asemeComment_593 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_591,asemeComment_593 skipwhite skipempty
syntax match asemeBlock_591 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_588,asemeBlock_589
syntax match asemeBlock_589 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_590 skipwhite skipempty
syntax region asemePunctuation_588 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_586,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_586 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_585,asemeComment_587 skipwhite skipempty
syntax region asemeComment_587 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_585,asemeComment_587 skipwhite skipempty
syntax match asemeComment_587 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_585,asemeComment_587 skipwhite skipempty
syntax match asemeText_585 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_583 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_584 skipwhite skipempty
syntax region asemeComment_584 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_584 skipwhite skipempty
syntax match asemeComment_584 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_584 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_582
syntax region asemePunctuation_582 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_581,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_581 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_545,asemeClause_548,asemeClause_551,asemeClause_554,asemeClause_557,asemeClause_560,asemeClause_563,asemeClause_566,asemeClause_569,asemePunctuation_576,asemeOperator_579
syntax match asemeOperator_579 /\v\=%(\=)@!/ contained nextgroup=asemeText_578,asemeComment_580 skipwhite skipempty
syntax region asemeComment_580 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_578,asemeComment_580 skipwhite skipempty
syntax match asemeComment_580 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_578,asemeComment_580 skipwhite skipempty
syntax match asemeText_578 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemePunctuation_576 /\v\,/ contained nextgroup=asemeChoice_572,asemeReference_574,asemeReference_575,asemeComment_577 skipwhite skipempty
syntax region asemeComment_577 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_572,asemeReference_574,asemeReference_575,asemeComment_577 skipwhite skipempty
syntax match asemeComment_577 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_572,asemeReference_574,asemeReference_575,asemeComment_577 skipwhite skipempty
syntax match asemeReference_575 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeReference_574 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeChoice_572 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_571,asemeComment_573 skipwhite skipempty
syntax region asemeComment_573 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_571,asemeComment_573 skipwhite skipempty
syntax match asemeComment_573 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_571,asemeComment_573 skipwhite skipempty
syntax match asemeReference_571 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_569 /\vends%(<|>)/ contained nextgroup=asemeReference_568,asemeComment_570 skipwhite skipempty
syntax region asemeComment_570 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_568,asemeComment_570 skipwhite skipempty
syntax match asemeComment_570 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_568,asemeComment_570 skipwhite skipempty
syntax match asemeReference_568 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_566 /\vwrites%(<|>)/ contained nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax region asemeComment_567 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax match asemeComment_567 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax match asemeReference_565 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_563 /\vfor%(<|>)/ contained nextgroup=asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax region asemeComment_564 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax match asemeComment_564 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_562,asemeComment_564 skipwhite skipempty
syntax match asemeNumber_562 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_560 /\vuses%(<|>)/ contained nextgroup=asemeReference_559,asemeComment_561 skipwhite skipempty
syntax region asemeComment_561 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_559,asemeComment_561 skipwhite skipempty
syntax match asemeComment_561 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_559,asemeComment_561 skipwhite skipempty
syntax match asemeReference_559 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_557 /\vas%(<|>)/ contained nextgroup=asemeChoice_556,asemeComment_558 skipwhite skipempty
syntax region asemeComment_558 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_556,asemeComment_558 skipwhite skipempty
syntax match asemeComment_558 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_556,asemeComment_558 skipwhite skipempty
syntax match asemeChoice_556 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_554 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_553,asemeComment_555 skipwhite skipempty
syntax region asemeComment_555 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_553,asemeComment_555 skipwhite skipempty
syntax match asemeComment_555 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_553,asemeComment_555 skipwhite skipempty
syntax match asemeNumber_553 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_551 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_550,asemeComment_552 skipwhite skipempty
syntax region asemeComment_552 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_550,asemeComment_552 skipwhite skipempty
syntax match asemeComment_552 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_550,asemeComment_552 skipwhite skipempty
syntax match asemeNumber_550 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_548 /\vevery%(<|>)/ contained nextgroup=asemeNumber_547,asemeComment_549 skipwhite skipempty
syntax region asemeComment_549 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_547,asemeComment_549 skipwhite skipempty
syntax match asemeComment_549 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_547,asemeComment_549 skipwhite skipempty
syntax match asemeNumber_547 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeClause_545 /\vreads%(<|>)/ contained nextgroup=asemeChoice_542,asemeReference_544,asemeComment_546 skipwhite skipempty
syntax region asemeComment_546 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_542,asemeReference_544,asemeComment_546 skipwhite skipempty
syntax match asemeComment_546 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_542,asemeReference_544,asemeComment_546 skipwhite skipempty
syntax match asemeReference_544 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeChoice_542 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_540,asemeComment_543 skipwhite skipempty
syntax region asemeComment_543 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_540,asemeComment_543 skipwhite skipempty
syntax match asemeComment_543 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_540,asemeComment_543 skipwhite skipempty
syntax match asemeReference_540 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_541 skipwhite skipempty
syntax match asemeDeclaration_538 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_539 skipwhite skipempty
syntax region asemeComment_539 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_539 skipwhite skipempty
syntax match asemeComment_539 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_539 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_537
syntax region asemePunctuation_537 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_536,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_536 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_503,asemeClause_506,asemeClause_509,asemeClause_512,asemeClause_515,asemeClause_518,asemeClause_521,asemeClause_524,asemeClause_527,asemePunctuation_534
syntax match asemePunctuation_534 /\v\,/ contained nextgroup=asemeChoice_530,asemeReference_532,asemeReference_533,asemeComment_535 skipwhite skipempty
syntax region asemeComment_535 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_530,asemeReference_532,asemeReference_533,asemeComment_535 skipwhite skipempty
syntax match asemeComment_535 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_530,asemeReference_532,asemeReference_533,asemeComment_535 skipwhite skipempty
syntax match asemeReference_533 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeReference_532 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeChoice_530 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_529,asemeComment_531 skipwhite skipempty
syntax region asemeComment_531 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_529,asemeComment_531 skipwhite skipempty
syntax match asemeComment_531 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_529,asemeComment_531 skipwhite skipempty
syntax match asemeReference_529 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_527 /\vends%(<|>)/ contained nextgroup=asemeReference_526,asemeComment_528 skipwhite skipempty
syntax region asemeComment_528 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_526,asemeComment_528 skipwhite skipempty
syntax match asemeComment_528 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_526,asemeComment_528 skipwhite skipempty
syntax match asemeReference_526 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_524 /\vwrites%(<|>)/ contained nextgroup=asemeReference_523,asemeComment_525 skipwhite skipempty
syntax region asemeComment_525 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_523,asemeComment_525 skipwhite skipempty
syntax match asemeComment_525 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_523,asemeComment_525 skipwhite skipempty
syntax match asemeReference_523 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_521 /\vfor%(<|>)/ contained nextgroup=asemeNumber_520,asemeComment_522 skipwhite skipempty
syntax region asemeComment_522 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_520,asemeComment_522 skipwhite skipempty
syntax match asemeComment_522 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_520,asemeComment_522 skipwhite skipempty
syntax match asemeNumber_520 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_518 /\vuses%(<|>)/ contained nextgroup=asemeReference_517,asemeComment_519 skipwhite skipempty
syntax region asemeComment_519 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_517,asemeComment_519 skipwhite skipempty
syntax match asemeComment_519 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_517,asemeComment_519 skipwhite skipempty
syntax match asemeReference_517 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_515 /\vas%(<|>)/ contained nextgroup=asemeChoice_514,asemeComment_516 skipwhite skipempty
syntax region asemeComment_516 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_514,asemeComment_516 skipwhite skipempty
syntax match asemeComment_516 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_514,asemeComment_516 skipwhite skipempty
syntax match asemeChoice_514 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_512 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_511,asemeComment_513 skipwhite skipempty
syntax region asemeComment_513 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_511,asemeComment_513 skipwhite skipempty
syntax match asemeComment_513 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_511,asemeComment_513 skipwhite skipempty
syntax match asemeNumber_511 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_509 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_508,asemeComment_510 skipwhite skipempty
syntax region asemeComment_510 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_508,asemeComment_510 skipwhite skipempty
syntax match asemeComment_510 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_508,asemeComment_510 skipwhite skipempty
syntax match asemeNumber_508 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_506 /\vevery%(<|>)/ contained nextgroup=asemeNumber_505,asemeComment_507 skipwhite skipempty
syntax region asemeComment_507 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_505,asemeComment_507 skipwhite skipempty
syntax match asemeComment_507 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_505,asemeComment_507 skipwhite skipempty
syntax match asemeNumber_505 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeClause_503 /\vreads%(<|>)/ contained nextgroup=asemeChoice_500,asemeReference_502,asemeComment_504 skipwhite skipempty
syntax region asemeComment_504 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_500,asemeReference_502,asemeComment_504 skipwhite skipempty
syntax match asemeComment_504 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_500,asemeReference_502,asemeComment_504 skipwhite skipempty
syntax match asemeReference_502 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeChoice_500 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_498,asemeComment_501 skipwhite skipempty
syntax region asemeComment_501 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_498,asemeComment_501 skipwhite skipempty
syntax match asemeComment_501 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_498,asemeComment_501 skipwhite skipempty
syntax match asemeReference_498 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_499 skipwhite skipempty
syntax match asemeDeclaration_496 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_497 skipwhite skipempty
syntax region asemeComment_497 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_497 skipwhite skipempty
syntax match asemeComment_497 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_497 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_495
syntax region asemePunctuation_495 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_493,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_493 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_492,asemeComment_494 skipwhite skipempty
syntax region asemeComment_494 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_492,asemeComment_494 skipwhite skipempty
syntax match asemeComment_494 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_492,asemeComment_494 skipwhite skipempty
syntax match asemeOperator_492 /\v\=%(\=)@!/ contained nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax cluster asemeFormula contains=asemeText_485,asemeNumber_487,asemeReference_488,asemeNumber_489,asemeOperator_490,asemePunctuation_491
syntax match asemePunctuation_491 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeOperator_490 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeNumber_489 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeReference_488 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeNumber_487 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeText_485 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormula,asemeComment_486 skipwhite skipempty
syntax match asemeDeclaration_483 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_481,asemeComment_484 skipwhite skipempty
syntax region asemeComment_484 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_481,asemeComment_484 skipwhite skipempty
syntax match asemeComment_484 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_481,asemeComment_484 skipwhite skipempty
syntax match asemeName_481 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_480,asemeComment_482 skipwhite skipempty
syntax region asemeComment_482 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_480,asemeComment_482 skipwhite skipempty
syntax match asemeComment_482 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_480,asemeComment_482 skipwhite skipempty
syntax match asemeOperator_480 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_478 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_476,asemeComment_479 skipwhite skipempty
syntax region asemeComment_479 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_476,asemeComment_479 skipwhite skipempty
syntax match asemeComment_479 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_476,asemeComment_479 skipwhite skipempty
syntax match asemeName_476 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_474,asemeComment_477 skipwhite skipempty
syntax region asemeComment_477 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_474,asemeComment_477 skipwhite skipempty
syntax match asemeComment_477 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_474,asemeComment_477 skipwhite skipempty
syntax match asemePunctuation_474 /\v\:/ contained nextgroup=asemeBuiltIn_472,asemeType_473,asemeComment_475 skipwhite skipempty
syntax region asemeComment_475 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_472,asemeType_473,asemeComment_475 skipwhite skipempty
syntax match asemeComment_475 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_472,asemeType_473,asemeComment_475 skipwhite skipempty
syntax match asemeType_473 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeBuiltIn_472 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_461,asemeOperator_463,asemeName_468,asemeBuiltIn_470,asemeType_471
syntax match asemeType_471 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeBuiltIn_470 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeName_468 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_466,asemeComment_469 skipwhite skipempty
syntax region asemeComment_469 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_466,asemeComment_469 skipwhite skipempty
syntax match asemeComment_469 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_466,asemeComment_469 skipwhite skipempty
syntax match asemePunctuation_466 /\v\:/ contained nextgroup=asemeBuiltIn_464,asemeType_465,asemeComment_467 skipwhite skipempty
syntax region asemeComment_467 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_464,asemeType_465,asemeComment_467 skipwhite skipempty
syntax match asemeComment_467 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_464,asemeType_465,asemeComment_467 skipwhite skipempty
syntax match asemeType_465 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeBuiltIn_464 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeOperator_463 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_461 /\v\:/ contained nextgroup=asemeBuiltIn_458,asemeType_460,asemeComment_462 skipwhite skipempty
syntax region asemeComment_462 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_458,asemeType_460,asemeComment_462 skipwhite skipempty
syntax match asemeComment_462 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_458,asemeType_460,asemeComment_462 skipwhite skipempty
syntax match asemeType_460 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeBuiltIn_458 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax region asemeComment_459 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeComment_459 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_459 skipwhite skipempty
syntax match asemeDeclaration_456 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_454,asemeComment_457 skipwhite skipempty
syntax region asemeComment_457 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_454,asemeComment_457 skipwhite skipempty
syntax match asemeComment_457 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_454,asemeComment_457 skipwhite skipempty
syntax match asemeName_454 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_453,@asemeCapabilityInBodyOfSrm,asemeComment_455 skipwhite skipempty
syntax region asemeComment_455 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_453,@asemeCapabilityInBodyOfSrm,asemeComment_455 skipwhite skipempty
syntax match asemeComment_455 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_453,@asemeCapabilityInBodyOfSrm,asemeComment_455 skipwhite skipempty
syntax match asemeText_453 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_444,asemePunctuation_447,asemeText_449,asemeName_451
syntax match asemeName_451 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_450,@asemeCapabilityInBodyOfSrm,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_450,@asemeCapabilityInBodyOfSrm,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_450,@asemeCapabilityInBodyOfSrm,asemeComment_452 skipwhite skipempty
syntax match asemeText_450 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax match asemeText_449 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax match asemePunctuation_447 /\v\,/ contained nextgroup=asemeReference_446,asemeComment_448 skipwhite skipempty
syntax region asemeComment_448 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_446,asemeComment_448 skipwhite skipempty
syntax match asemeComment_448 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_446,asemeComment_448 skipwhite skipempty
syntax match asemeReference_446 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax match asemeOperator_444 /\v\=%(\=)@!/ contained nextgroup=asemeReference_442,asemeComment_445 skipwhite skipempty
syntax region asemeComment_445 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_442,asemeComment_445 skipwhite skipempty
syntax match asemeComment_445 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_442,asemeComment_445 skipwhite skipempty
syntax match asemeReference_442 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax region asemeComment_443 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax match asemeComment_443 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_443 skipwhite skipempty
syntax match asemeDeclaration_440 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_438,asemeComment_441 skipwhite skipempty
syntax region asemeComment_441 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_438,asemeComment_441 skipwhite skipempty
syntax match asemeComment_441 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_438,asemeComment_441 skipwhite skipempty
syntax match asemeReference_438 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_436,asemeComment_439 skipwhite skipempty
syntax region asemeComment_439 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_436,asemeComment_439 skipwhite skipempty
syntax match asemeComment_439 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_436,asemeComment_439 skipwhite skipempty
syntax match asemePunctuation_436 /\v\./ contained nextgroup=asemeReference_435,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_435,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_435,asemeComment_437 skipwhite skipempty
syntax match asemeReference_435 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_412,asemeClause_415,asemePunctuation_425,asemePunctuation_428,asemeReference_433
syntax match asemeReference_433 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_431,@asemePlaysInBodyOfSrm,asemeComment_434 skipwhite skipempty
syntax region asemeComment_434 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_431,@asemePlaysInBodyOfSrm,asemeComment_434 skipwhite skipempty
syntax match asemeComment_434 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_431,@asemePlaysInBodyOfSrm,asemeComment_434 skipwhite skipempty
syntax match asemePunctuation_431 /\v\./ contained nextgroup=asemeReference_430,asemeComment_432 skipwhite skipempty
syntax region asemeComment_432 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_430,asemeComment_432 skipwhite skipempty
syntax match asemeComment_432 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_430,asemeComment_432 skipwhite skipempty
syntax match asemeReference_430 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemePunctuation_428 /\v\./ contained nextgroup=asemeReference_427,asemeComment_429 skipwhite skipempty
syntax region asemeComment_429 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_427,asemeComment_429 skipwhite skipempty
syntax match asemeComment_429 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_427,asemeComment_429 skipwhite skipempty
syntax match asemeReference_427 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemePunctuation_425 /\v\,/ contained nextgroup=asemeReference_423,asemeComment_426 skipwhite skipempty
syntax region asemeComment_426 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_423,asemeComment_426 skipwhite skipempty
syntax match asemeComment_426 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_423,asemeComment_426 skipwhite skipempty
syntax match asemeReference_423 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_418,asemePunctuation_421,asemeComment_424 skipwhite skipempty
syntax region asemeComment_424 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_418,asemePunctuation_421,asemeComment_424 skipwhite skipempty
syntax match asemeComment_424 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_418,asemePunctuation_421,asemeComment_424 skipwhite skipempty
syntax match asemePunctuation_421 /\v\./ contained nextgroup=asemeReference_420,asemeComment_422 skipwhite skipempty
syntax region asemeComment_422 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_420,asemeComment_422 skipwhite skipempty
syntax match asemeComment_422 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_420,asemeComment_422 skipwhite skipempty
syntax match asemeReference_420 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemeOperator_418 /\v\=%(\=)@!/ contained nextgroup=asemeReference_417,asemeComment_419 skipwhite skipempty
syntax region asemeComment_419 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_417,asemeComment_419 skipwhite skipempty
syntax match asemeComment_419 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_417,asemeComment_419 skipwhite skipempty
syntax match asemeReference_417 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemeClause_415 /\vas%(<|>)/ contained nextgroup=asemeReference_414,asemeComment_416 skipwhite skipempty
syntax region asemeComment_416 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_414,asemeComment_416 skipwhite skipempty
syntax match asemeComment_416 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_414,asemeComment_416 skipwhite skipempty
syntax match asemeReference_414 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemeClause_412 /\vwith%(<|>)/ contained nextgroup=asemeReference_410,asemeComment_413 skipwhite skipempty
syntax region asemeComment_413 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_410,asemeComment_413 skipwhite skipempty
syntax match asemeComment_413 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_410,asemeComment_413 skipwhite skipempty
syntax match asemeReference_410 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_408,asemeComment_411 skipwhite skipempty
syntax region asemeComment_411 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_408,asemeComment_411 skipwhite skipempty
syntax match asemeComment_411 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_408,asemeComment_411 skipwhite skipempty
syntax match asemeOperator_408 /\v\=%(\=)@!/ contained nextgroup=asemeReference_406,asemeComment_409 skipwhite skipempty
syntax region asemeComment_409 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_406,asemeComment_409 skipwhite skipempty
syntax match asemeComment_409 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_406,asemeComment_409 skipwhite skipempty
syntax match asemeReference_406 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax region asemeComment_407 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemeComment_407 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_407 skipwhite skipempty
syntax match asemeDeclaration_404 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_403,asemeComment_405 skipwhite skipempty
syntax region asemeComment_405 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_403,asemeComment_405 skipwhite skipempty
syntax match asemeComment_405 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_403,asemeComment_405 skipwhite skipempty
syntax match asemeReference_403 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_400,asemeReference_402
syntax match asemeReference_402 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemePunctuation_400 /\v\,/ contained nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax region asemeComment_401 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax match asemeComment_401 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax match asemeReference_398 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax region asemeComment_399 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeComment_399 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeClause_396 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_394,asemeComment_397 skipwhite skipempty
syntax region asemeComment_397 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_394,asemeComment_397 skipwhite skipempty
syntax match asemeComment_397 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_394,asemeComment_397 skipwhite skipempty
syntax match asemeBlock_394 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_395 skipwhite skipempty
syntax region asemeComment_395 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_395 skipwhite skipempty
syntax match asemeComment_395 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_395 skipwhite skipempty
syntax match asemeDeclaration_392 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_391,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_391,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_391,asemeComment_393 skipwhite skipempty
syntax match asemeBlock_391 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_390 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_388,asemeBlock_389
syntax match asemeBlock_389 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_390 skipwhite skipempty
syntax region asemeComment_390 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_390 skipwhite skipempty
syntax match asemeComment_390 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_390 skipwhite skipempty
syntax region asemePunctuation_388 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_284,asemeDeclaration_287,asemeDeclaration_315,asemeDeclaration_319,asemeDeclaration_386,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_386 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_384,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_384,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_384,asemeComment_387 skipwhite skipempty
syntax match asemeBlock_384 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_383,@asemeControlInBodyOfAip,asemeComment_385 skipwhite skipempty
syntax region asemeComment_385 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_383,@asemeControlInBodyOfAip,asemeComment_385 skipwhite skipempty
syntax match asemeComment_385 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_383,@asemeControlInBodyOfAip,asemeComment_385 skipwhite skipempty
syntax match asemeOperator_383 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_377,asemeOperator_378,asemeBlock_381
syntax match asemeBlock_381 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_380,@asemeControlInBodyOfAip,asemeComment_382 skipwhite skipempty
syntax region asemeComment_382 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_380,@asemeControlInBodyOfAip,asemeComment_382 skipwhite skipempty
syntax match asemeComment_382 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_380,@asemeControlInBodyOfAip,asemeComment_382 skipwhite skipempty
syntax match asemeOperator_380 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
syntax match asemeOperator_378 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_379 skipwhite skipempty
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
highlight default link asemeBlock_381 asemeBlock
highlight default link asemeBlock_384 asemeBlock
highlight default link asemeBlock_389 asemeBlock
highlight default link asemeBlock_391 asemeBlock
highlight default link asemeBlock_394 asemeBlock
highlight default link asemeBlock_45 asemeBlock
highlight default link asemeBlock_47 asemeBlock
highlight default link asemeBlock_589 asemeBlock
highlight default link asemeBlock_591 asemeBlock
highlight default link asemeBlock_597 asemeBlock
highlight default link asemeBlock_600 asemeBlock
highlight default link asemeBlock_605 asemeBlock
highlight default link asemeBlock_606 asemeBlock
highlight default link asemeBlock_611 asemeBlock
highlight default link asemeBlock_677 asemeBlock
highlight default link asemeBlock_679 asemeBlock
highlight default link asemeBlock_700 asemeBlock
highlight default link asemeBlock_702 asemeBlock
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
highlight default link asemeBuiltIn_458 asemeBuiltIn
highlight default link asemeBuiltIn_464 asemeBuiltIn
highlight default link asemeBuiltIn_470 asemeBuiltIn
highlight default link asemeBuiltIn_472 asemeBuiltIn
highlight default link asemeBuiltIn_56 asemeBuiltIn
highlight default link asemeBuiltIn_61 asemeBuiltIn
highlight default link asemeBuiltIn_645 asemeBuiltIn
highlight default link asemeBuiltIn_651 asemeBuiltIn
highlight default link asemeBuiltIn_657 asemeBuiltIn
highlight default link asemeBuiltIn_659 asemeBuiltIn
highlight default link asemeBuiltIn_67 asemeBuiltIn
highlight default link asemeCall_217 asemeCall
highlight default link asemeCall_23 asemeCall
highlight default link asemeCall_341 asemeCall
highlight default link asemeCall_366 asemeCall
highlight default link asemeChoice_160 asemeChoice
highlight default link asemeChoice_289 asemeChoice
highlight default link asemeChoice_500 asemeChoice
highlight default link asemeChoice_514 asemeChoice
highlight default link asemeChoice_530 asemeChoice
highlight default link asemeChoice_542 asemeChoice
highlight default link asemeChoice_556 asemeChoice
highlight default link asemeChoice_572 asemeChoice
highlight default link asemeChoice_620 asemeChoice
highlight default link asemeChoice_624 asemeChoice
highlight default link asemeChoice_632 asemeChoice
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
highlight default link asemeClause_396 asemeClause
highlight default link asemeClause_412 asemeClause
highlight default link asemeClause_415 asemeClause
highlight default link asemeClause_503 asemeClause
highlight default link asemeClause_506 asemeClause
highlight default link asemeClause_509 asemeClause
highlight default link asemeClause_512 asemeClause
highlight default link asemeClause_515 asemeClause
highlight default link asemeClause_518 asemeClause
highlight default link asemeClause_521 asemeClause
highlight default link asemeClause_524 asemeClause
highlight default link asemeClause_527 asemeClause
highlight default link asemeClause_545 asemeClause
highlight default link asemeClause_548 asemeClause
highlight default link asemeClause_551 asemeClause
highlight default link asemeClause_554 asemeClause
highlight default link asemeClause_557 asemeClause
highlight default link asemeClause_560 asemeClause
highlight default link asemeClause_563 asemeClause
highlight default link asemeClause_566 asemeClause
highlight default link asemeClause_569 asemeClause
highlight default link asemeClause_607 asemeClause
highlight default link asemeClause_616 asemeClause
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
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_390 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_395 asemeComment
highlight default link asemeComment_397 asemeComment
highlight default link asemeComment_399 asemeComment
highlight default link asemeComment_401 asemeComment
highlight default link asemeComment_405 asemeComment
highlight default link asemeComment_407 asemeComment
highlight default link asemeComment_409 asemeComment
highlight default link asemeComment_411 asemeComment
highlight default link asemeComment_413 asemeComment
highlight default link asemeComment_416 asemeComment
highlight default link asemeComment_419 asemeComment
highlight default link asemeComment_422 asemeComment
highlight default link asemeComment_424 asemeComment
highlight default link asemeComment_426 asemeComment
highlight default link asemeComment_429 asemeComment
highlight default link asemeComment_432 asemeComment
highlight default link asemeComment_434 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_439 asemeComment
highlight default link asemeComment_441 asemeComment
highlight default link asemeComment_443 asemeComment
highlight default link asemeComment_445 asemeComment
highlight default link asemeComment_448 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_455 asemeComment
highlight default link asemeComment_457 asemeComment
highlight default link asemeComment_459 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_462 asemeComment
highlight default link asemeComment_467 asemeComment
highlight default link asemeComment_469 asemeComment
highlight default link asemeComment_475 asemeComment
highlight default link asemeComment_477 asemeComment
highlight default link asemeComment_479 asemeComment
highlight default link asemeComment_482 asemeComment
highlight default link asemeComment_484 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_49 asemeComment
highlight default link asemeComment_494 asemeComment
highlight default link asemeComment_497 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_501 asemeComment
highlight default link asemeComment_504 asemeComment
highlight default link asemeComment_507 asemeComment
highlight default link asemeComment_51 asemeComment
highlight default link asemeComment_510 asemeComment
highlight default link asemeComment_513 asemeComment
highlight default link asemeComment_516 asemeComment
highlight default link asemeComment_519 asemeComment
highlight default link asemeComment_522 asemeComment
highlight default link asemeComment_525 asemeComment
highlight default link asemeComment_528 asemeComment
highlight default link asemeComment_53 asemeComment
highlight default link asemeComment_531 asemeComment
highlight default link asemeComment_535 asemeComment
highlight default link asemeComment_539 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_543 asemeComment
highlight default link asemeComment_546 asemeComment
highlight default link asemeComment_549 asemeComment
highlight default link asemeComment_552 asemeComment
highlight default link asemeComment_555 asemeComment
highlight default link asemeComment_558 asemeComment
highlight default link asemeComment_561 asemeComment
highlight default link asemeComment_564 asemeComment
highlight default link asemeComment_567 asemeComment
highlight default link asemeComment_57 asemeComment
highlight default link asemeComment_570 asemeComment
highlight default link asemeComment_573 asemeComment
highlight default link asemeComment_577 asemeComment
highlight default link asemeComment_580 asemeComment
highlight default link asemeComment_584 asemeComment
highlight default link asemeComment_587 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_593 asemeComment
highlight default link asemeComment_595 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_603 asemeComment
highlight default link asemeComment_608 asemeComment
highlight default link asemeComment_610 asemeComment
highlight default link asemeComment_613 asemeComment
highlight default link asemeComment_615 asemeComment
highlight default link asemeComment_617 asemeComment
highlight default link asemeComment_62 asemeComment
highlight default link asemeComment_621 asemeComment
highlight default link asemeComment_625 asemeComment
highlight default link asemeComment_627 asemeComment
highlight default link asemeComment_633 asemeComment
highlight default link asemeComment_635 asemeComment
highlight default link asemeComment_637 asemeComment
highlight default link asemeComment_640 asemeComment
highlight default link asemeComment_642 asemeComment
highlight default link asemeComment_644 asemeComment
highlight default link asemeComment_646 asemeComment
highlight default link asemeComment_649 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_654 asemeComment
highlight default link asemeComment_656 asemeComment
highlight default link asemeComment_662 asemeComment
highlight default link asemeComment_664 asemeComment
highlight default link asemeComment_666 asemeComment
highlight default link asemeComment_669 asemeComment
highlight default link asemeComment_671 asemeComment
highlight default link asemeComment_673 asemeComment
highlight default link asemeComment_675 asemeComment
highlight default link asemeComment_678 asemeComment
highlight default link asemeComment_68 asemeComment
highlight default link asemeComment_681 asemeComment
highlight default link asemeComment_683 asemeComment
highlight default link asemeComment_685 asemeComment
highlight default link asemeComment_687 asemeComment
highlight default link asemeComment_689 asemeComment
highlight default link asemeComment_691 asemeComment
highlight default link asemeComment_694 asemeComment
highlight default link asemeComment_697 asemeComment
highlight default link asemeComment_701 asemeComment
highlight default link asemeComment_704 asemeComment
highlight default link asemeComment_72 asemeComment
highlight default link asemeComment_730 asemeComment
highlight default link asemeComment_733 asemeComment
highlight default link asemeComment_741 asemeComment
highlight default link asemeComment_744 asemeComment
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
highlight default link asemeDeclaration_386 asemeDeclaration
highlight default link asemeDeclaration_392 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_404 asemeDeclaration
highlight default link asemeDeclaration_440 asemeDeclaration
highlight default link asemeDeclaration_456 asemeDeclaration
highlight default link asemeDeclaration_478 asemeDeclaration
highlight default link asemeDeclaration_48 asemeDeclaration
highlight default link asemeDeclaration_483 asemeDeclaration
highlight default link asemeDeclaration_496 asemeDeclaration
highlight default link asemeDeclaration_538 asemeDeclaration
highlight default link asemeDeclaration_583 asemeDeclaration
highlight default link asemeDeclaration_586 asemeDeclaration
highlight default link asemeDeclaration_592 asemeDeclaration
highlight default link asemeDeclaration_602 asemeDeclaration
highlight default link asemeDeclaration_609 asemeDeclaration
highlight default link asemeDeclaration_612 asemeDeclaration
highlight default link asemeDeclaration_636 asemeDeclaration
highlight default link asemeDeclaration_64 asemeDeclaration
highlight default link asemeDeclaration_665 asemeDeclaration
highlight default link asemeDeclaration_670 asemeDeclaration
highlight default link asemeDeclaration_672 asemeDeclaration
highlight default link asemeDeclaration_674 asemeDeclaration
highlight default link asemeDeclaration_680 asemeDeclaration
highlight default link asemeDeclaration_703 asemeDeclaration
highlight default link asemeDeclaration_732 asemeDeclaration
highlight default link asemeDeclaration_74 asemeDeclaration
highlight default link asemeDeclaration_743 asemeDeclaration
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
highlight default link asemeName_451 asemeName
highlight default link asemeName_454 asemeName
highlight default link asemeName_468 asemeName
highlight default link asemeName_476 asemeName
highlight default link asemeName_481 asemeName
highlight default link asemeName_493 asemeName
highlight default link asemeName_536 asemeName
highlight default link asemeName_55 asemeName
highlight default link asemeName_581 asemeName
highlight default link asemeName_59 asemeName
highlight default link asemeName_60 asemeName
highlight default link asemeName_618 asemeName
highlight default link asemeName_622 asemeName
highlight default link asemeName_628 asemeName
highlight default link asemeName_630 asemeName
highlight default link asemeName_655 asemeName
highlight default link asemeName_66 asemeName
highlight default link asemeName_663 asemeName
highlight default link asemeName_668 asemeName
highlight default link asemeName_692 asemeName
highlight default link asemeName_698 asemeName
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
highlight default link asemeNumber_487 asemeNumber
highlight default link asemeNumber_489 asemeNumber
highlight default link asemeNumber_50 asemeNumber
highlight default link asemeNumber_505 asemeNumber
highlight default link asemeNumber_508 asemeNumber
highlight default link asemeNumber_511 asemeNumber
highlight default link asemeNumber_520 asemeNumber
highlight default link asemeNumber_547 asemeNumber
highlight default link asemeNumber_550 asemeNumber
highlight default link asemeNumber_553 asemeNumber
highlight default link asemeNumber_562 asemeNumber
highlight default link asemeNumber_626 asemeNumber
highlight default link asemeNumber_634 asemeNumber
highlight default link asemeNumber_639 asemeNumber
highlight default link asemeNumber_643 asemeNumber
highlight default link asemeNumber_684 asemeNumber
highlight default link asemeNumber_688 asemeNumber
highlight default link asemeNumber_706 asemeNumber
highlight default link asemeNumber_712 asemeNumber
highlight default link asemeNumber_718 asemeNumber
highlight default link asemeNumber_724 asemeNumber
highlight default link asemeNumber_735 asemeNumber
highlight default link asemeNumber_747 asemeNumber
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
highlight default link asemeOperator_378 asemeOperator
highlight default link asemeOperator_380 asemeOperator
highlight default link asemeOperator_383 asemeOperator
highlight default link asemeOperator_408 asemeOperator
highlight default link asemeOperator_418 asemeOperator
highlight default link asemeOperator_444 asemeOperator
highlight default link asemeOperator_463 asemeOperator
highlight default link asemeOperator_480 asemeOperator
highlight default link asemeOperator_490 asemeOperator
highlight default link asemeOperator_492 asemeOperator
highlight default link asemeOperator_52 asemeOperator
highlight default link asemeOperator_579 asemeOperator
highlight default link asemeOperator_594 asemeOperator
highlight default link asemeOperator_596 asemeOperator
highlight default link asemeOperator_599 asemeOperator
highlight default link asemeOperator_641 asemeOperator
highlight default link asemeOperator_650 asemeOperator
highlight default link asemeOperator_667 asemeOperator
highlight default link asemeOperator_708 asemeOperator
highlight default link asemeOperator_714 asemeOperator
highlight default link asemeOperator_720 asemeOperator
highlight default link asemeOperator_726 asemeOperator
highlight default link asemeOperator_737 asemeOperator
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
highlight default link asemePunctuation_388 asemePunctuation
highlight default link asemePunctuation_400 asemePunctuation
highlight default link asemePunctuation_421 asemePunctuation
highlight default link asemePunctuation_425 asemePunctuation
highlight default link asemePunctuation_428 asemePunctuation
highlight default link asemePunctuation_43 asemePunctuation
highlight default link asemePunctuation_431 asemePunctuation
highlight default link asemePunctuation_436 asemePunctuation
highlight default link asemePunctuation_44 asemePunctuation
highlight default link asemePunctuation_447 asemePunctuation
highlight default link asemePunctuation_461 asemePunctuation
highlight default link asemePunctuation_466 asemePunctuation
highlight default link asemePunctuation_474 asemePunctuation
highlight default link asemePunctuation_491 asemePunctuation
highlight default link asemePunctuation_495 asemePunctuation
highlight default link asemePunctuation_534 asemePunctuation
highlight default link asemePunctuation_537 asemePunctuation
highlight default link asemePunctuation_54 asemePunctuation
highlight default link asemePunctuation_576 asemePunctuation
highlight default link asemePunctuation_582 asemePunctuation
highlight default link asemePunctuation_588 asemePunctuation
highlight default link asemePunctuation_604 asemePunctuation
highlight default link asemePunctuation_638 asemePunctuation
highlight default link asemePunctuation_648 asemePunctuation
highlight default link asemePunctuation_653 asemePunctuation
highlight default link asemePunctuation_661 asemePunctuation
highlight default link asemePunctuation_676 asemePunctuation
highlight default link asemePunctuation_682 asemePunctuation
highlight default link asemePunctuation_686 asemePunctuation
highlight default link asemePunctuation_690 asemePunctuation
highlight default link asemePunctuation_693 asemePunctuation
highlight default link asemePunctuation_696 asemePunctuation
highlight default link asemePunctuation_699 asemePunctuation
highlight default link asemePunctuation_70 asemePunctuation
highlight default link asemePunctuation_709 asemePunctuation
highlight default link asemePunctuation_710 asemePunctuation
highlight default link asemePunctuation_715 asemePunctuation
highlight default link asemePunctuation_716 asemePunctuation
highlight default link asemePunctuation_721 asemePunctuation
highlight default link asemePunctuation_722 asemePunctuation
highlight default link asemePunctuation_727 asemePunctuation
highlight default link asemePunctuation_728 asemePunctuation
highlight default link asemePunctuation_738 asemePunctuation
highlight default link asemePunctuation_739 asemePunctuation
highlight default link asemePunctuation_750 asemePunctuation
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
highlight default link asemeReference_398 asemeReference
highlight default link asemeReference_402 asemeReference
highlight default link asemeReference_403 asemeReference
highlight default link asemeReference_406 asemeReference
highlight default link asemeReference_41 asemeReference
highlight default link asemeReference_410 asemeReference
highlight default link asemeReference_414 asemeReference
highlight default link asemeReference_417 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_420 asemeReference
highlight default link asemeReference_423 asemeReference
highlight default link asemeReference_427 asemeReference
highlight default link asemeReference_430 asemeReference
highlight default link asemeReference_433 asemeReference
highlight default link asemeReference_435 asemeReference
highlight default link asemeReference_438 asemeReference
highlight default link asemeReference_442 asemeReference
highlight default link asemeReference_446 asemeReference
highlight default link asemeReference_488 asemeReference
highlight default link asemeReference_498 asemeReference
highlight default link asemeReference_502 asemeReference
highlight default link asemeReference_517 asemeReference
highlight default link asemeReference_523 asemeReference
highlight default link asemeReference_526 asemeReference
highlight default link asemeReference_529 asemeReference
highlight default link asemeReference_532 asemeReference
highlight default link asemeReference_533 asemeReference
highlight default link asemeReference_540 asemeReference
highlight default link asemeReference_544 asemeReference
highlight default link asemeReference_559 asemeReference
highlight default link asemeReference_565 asemeReference
highlight default link asemeReference_568 asemeReference
highlight default link asemeReference_571 asemeReference
highlight default link asemeReference_574 asemeReference
highlight default link asemeReference_575 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_614 asemeReference
highlight default link asemeReference_695 asemeReference
highlight default link asemeReference_707 asemeReference
highlight default link asemeReference_713 asemeReference
highlight default link asemeReference_719 asemeReference
highlight default link asemeReference_725 asemeReference
highlight default link asemeReference_736 asemeReference
highlight default link asemeReference_748 asemeReference
highlight default link asemeReference_749 asemeReference
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
highlight default link asemeText_449 asemeText
highlight default link asemeText_450 asemeText
highlight default link asemeText_453 asemeText
highlight default link asemeText_485 asemeText
highlight default link asemeText_578 asemeText
highlight default link asemeText_585 asemeText
highlight default link asemeText_619 asemeText
highlight default link asemeText_623 asemeText
highlight default link asemeText_629 asemeText
highlight default link asemeText_631 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_705 asemeText
highlight default link asemeText_711 asemeText
highlight default link asemeText_717 asemeText
highlight default link asemeText_723 asemeText
highlight default link asemeText_729 asemeText
highlight default link asemeText_731 asemeText
highlight default link asemeText_734 asemeText
highlight default link asemeText_740 asemeText
highlight default link asemeText_742 asemeText
highlight default link asemeText_745 asemeText
highlight default link asemeText_746 asemeText
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
highlight default link asemeType_460 asemeType
highlight default link asemeType_465 asemeType
highlight default link asemeType_471 asemeType
highlight default link asemeType_473 asemeType
highlight default link asemeType_58 asemeType
highlight default link asemeType_63 asemeType
highlight default link asemeType_647 asemeType
highlight default link asemeType_652 asemeType
highlight default link asemeType_658 asemeType
highlight default link asemeType_660 asemeType
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
