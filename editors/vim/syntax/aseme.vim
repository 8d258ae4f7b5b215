" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
syntax sync fromstart
syntax match asemeReference_736 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_735 /\v\w+/
syntax match asemeNumber_734 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_733 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_732 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_737 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_732,asemeText_733,asemeNumber_734,asemeReference_735,asemeReference_736,asemePunctuation_737,asemeComment
syntax match asemeReference_42 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_41 /\v\w+/ contained
syntax match asemeNumber_40 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_39 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_38 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_43 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_30,asemeDeclaration_48,asemeDeclaration_74,asemeDeclaration_101,asemeDeclaration_131,asemeDeclaration_154,asemeDeclaration_186,asemeDeclaration_384,asemeDeclaration_596,asemeDeclaration_599,asemeDeclaration_667,asemeDeclaration_690,asemeDeclaration_719,asemeDeclaration_730,asemeText_732,asemeText_733,asemeNumber_734,asemeReference_735,asemeReference_736,asemePunctuation_737,asemeComment
syntax match asemeDeclaration_730 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_729,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_729,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_729,asemeComment_731 skipwhite skipempty
syntax match asemeText_729 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_728 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_726,asemeText_727
syntax match asemeText_727 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_728 skipwhite skipempty
syntax region asemeComment_728 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_728 skipwhite skipempty
syntax match asemeComment_728 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_728 skipwhite skipempty
syntax region asemePunctuation_726 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_709,asemeText_721,asemeNumber_722,asemeReference_723,asemeOperator_724,asemePunctuation_725,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_725 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_724 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_723 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_722 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_721 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_719 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_718,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_718,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_718,asemeComment_720 skipwhite skipempty
syntax match asemeText_718 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_717 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_715,asemeText_716
syntax match asemeText_716 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_717 skipwhite skipempty
syntax region asemeComment_717 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_717 skipwhite skipempty
syntax match asemeComment_717 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_717 skipwhite skipempty
syntax region asemePunctuation_715 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_709,asemeText_710,asemeNumber_711,asemeReference_712,asemeOperator_713,asemePunctuation_714,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_714 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_713 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_712 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_711 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_710 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_709 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_703,asemeText_704,asemeNumber_705,asemeReference_706,asemeOperator_707,asemePunctuation_708,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_708 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_707 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_706 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_705 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_704 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_703 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_697,asemeText_698,asemeNumber_699,asemeReference_700,asemeOperator_701,asemePunctuation_702,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_702 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_701 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_700 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_699 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_698 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_697 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_692,asemeNumber_693,asemeReference_694,asemeOperator_695,asemePunctuation_696,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_696 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_695 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_694 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_693 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_692 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_690 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_689,asemeComment_691 skipwhite skipempty
syntax region asemeComment_691 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_689,asemeComment_691 skipwhite skipempty
syntax match asemeComment_691 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_689,asemeComment_691 skipwhite skipempty
syntax match asemeBlock_689 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_688 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_686,asemeBlock_687
syntax match asemeBlock_687 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_688 skipwhite skipempty
syntax region asemeComment_688 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_688 skipwhite skipempty
syntax match asemeComment_688 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_688 skipwhite skipempty
syntax region asemePunctuation_686 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_685,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_685 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_670 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemePunctuation_677,asemePunctuation_680,asemePunctuation_683
syntax match asemePunctuation_683 /\v\:/ contained nextgroup=asemeReference_682,asemeComment_684 skipwhite skipempty
syntax region asemeComment_684 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_682,asemeComment_684 skipwhite skipempty
syntax match asemeComment_684 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_682,asemeComment_684 skipwhite skipempty
syntax match asemeReference_682 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_670 skipwhite skipempty
syntax match asemePunctuation_680 /\v\,/ contained nextgroup=asemeName_679,asemeComment_681 skipwhite skipempty
syntax region asemeComment_681 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_679,asemeComment_681 skipwhite skipempty
syntax match asemeComment_681 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_679,asemeComment_681 skipwhite skipempty
syntax match asemeName_679 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_670 skipwhite skipempty
syntax match asemePunctuation_677 /\v\[/ contained nextgroup=asemeNumber_675,asemeComment_678 skipwhite skipempty
syntax region asemeComment_678 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_675,asemeComment_678 skipwhite skipempty
syntax match asemeComment_678 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_675,asemeComment_678 skipwhite skipempty
syntax match asemeNumber_675 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_673,asemeComment_676 skipwhite skipempty
syntax region asemeComment_676 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_673,asemeComment_676 skipwhite skipempty
syntax match asemeComment_676 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_673,asemeComment_676 skipwhite skipempty
syntax match asemePunctuation_673 /\v\.\./ contained nextgroup=asemeNumber_671,asemeComment_674 skipwhite skipempty
syntax region asemeComment_674 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_671,asemeComment_674 skipwhite skipempty
syntax match asemeComment_674 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_671,asemeComment_674 skipwhite skipempty
syntax match asemeNumber_671 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_669,asemeComment_672 skipwhite skipempty
syntax region asemeComment_672 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_669,asemeComment_672 skipwhite skipempty
syntax match asemeComment_672 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_669,asemeComment_672 skipwhite skipempty
syntax match asemePunctuation_669 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_670 skipwhite skipempty
syntax region asemeComment_670 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_670 skipwhite skipempty
syntax match asemeComment_670 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_670 skipwhite skipempty
syntax match asemeDeclaration_667 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_666,asemeComment_668 skipwhite skipempty
syntax region asemeComment_668 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_666,asemeComment_668 skipwhite skipempty
syntax match asemeComment_668 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_666,asemeComment_668 skipwhite skipempty
syntax match asemeBlock_666 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_665 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_663,asemeBlock_664
syntax match asemeBlock_664 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_665 skipwhite skipempty
syntax region asemeComment_665 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_665 skipwhite skipempty
syntax match asemeComment_665 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_665 skipwhite skipempty
syntax region asemePunctuation_663 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_623,asemeNumber_630,asemeDeclaration_652,asemeDeclaration_657,asemeDeclaration_659,asemeDeclaration_661,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_661 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_662 skipwhite skipempty
syntax region asemeComment_662 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_662 skipwhite skipempty
syntax match asemeComment_662 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_662 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_574
syntax match asemeDeclaration_659 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_660 skipwhite skipempty
syntax region asemeComment_660 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_660 skipwhite skipempty
syntax match asemeComment_660 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_660 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_529
syntax match asemeDeclaration_657 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_655,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_655,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_655,asemeComment_658 skipwhite skipempty
syntax match asemeName_655 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_654,asemeComment_656 skipwhite skipempty
syntax region asemeComment_656 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_654,asemeComment_656 skipwhite skipempty
syntax match asemeComment_656 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_654,asemeComment_656 skipwhite skipempty
syntax match asemeOperator_654 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_652 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_650,asemeComment_653 skipwhite skipempty
syntax region asemeComment_653 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_650,asemeComment_653 skipwhite skipempty
syntax match asemeComment_653 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_650,asemeComment_653 skipwhite skipempty
syntax match asemeName_650 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_648,asemeComment_651 skipwhite skipempty
syntax region asemeComment_651 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_648,asemeComment_651 skipwhite skipempty
syntax match asemeComment_651 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_648,asemeComment_651 skipwhite skipempty
syntax match asemePunctuation_648 /\v\:/ contained nextgroup=asemeBuiltIn_646,asemeType_647,asemeComment_649 skipwhite skipempty
syntax region asemeComment_649 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_646,asemeType_647,asemeComment_649 skipwhite skipempty
syntax match asemeComment_649 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_646,asemeType_647,asemeComment_649 skipwhite skipempty
syntax match asemeType_647 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeBuiltIn_646 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_635,asemeOperator_637,asemeName_642,asemeBuiltIn_644,asemeType_645
syntax match asemeType_645 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeBuiltIn_644 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeName_642 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_640,asemeComment_643 skipwhite skipempty
syntax region asemeComment_643 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_640,asemeComment_643 skipwhite skipempty
syntax match asemeComment_643 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_640,asemeComment_643 skipwhite skipempty
syntax match asemePunctuation_640 /\v\:/ contained nextgroup=asemeBuiltIn_638,asemeType_639,asemeComment_641 skipwhite skipempty
syntax region asemeComment_641 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_638,asemeType_639,asemeComment_641 skipwhite skipempty
syntax match asemeComment_641 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_638,asemeType_639,asemeComment_641 skipwhite skipempty
syntax match asemeType_639 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeBuiltIn_638 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeOperator_637 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_635 /\v\:/ contained nextgroup=asemeBuiltIn_632,asemeType_634,asemeComment_636 skipwhite skipempty
syntax region asemeComment_636 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_632,asemeType_634,asemeComment_636 skipwhite skipempty
syntax match asemeComment_636 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_632,asemeType_634,asemeComment_636 skipwhite skipempty
syntax match asemeType_634 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeBuiltIn_632 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax region asemeComment_633 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeComment_633 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_633 skipwhite skipempty
syntax match asemeNumber_630 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_628,asemeComment_631 skipwhite skipempty
syntax region asemeComment_631 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_628,asemeComment_631 skipwhite skipempty
syntax match asemeComment_631 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_628,asemeComment_631 skipwhite skipempty
syntax match asemeOperator_628 /\v\-\>/ contained nextgroup=asemeNumber_626,asemeComment_629 skipwhite skipempty
syntax region asemeComment_629 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_626,asemeComment_629 skipwhite skipempty
syntax match asemeComment_629 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_626,asemeComment_629 skipwhite skipempty
syntax match asemeNumber_626 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_625,asemeComment_627 skipwhite skipempty
syntax region asemeComment_627 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_625,asemeComment_627 skipwhite skipempty
syntax match asemeComment_627 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_625,asemeComment_627 skipwhite skipempty
syntax match asemePunctuation_625 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeDeclaration_623 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_621,asemeComment_624 skipwhite skipempty
syntax region asemeComment_624 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_621,asemeComment_624 skipwhite skipempty
syntax match asemeComment_624 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_621,asemeComment_624 skipwhite skipempty
syntax match asemeNumber_621 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_619,asemeComment_622 skipwhite skipempty
syntax region asemeComment_622 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_619,asemeComment_622 skipwhite skipempty
syntax match asemeComment_622 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_619,asemeComment_622 skipwhite skipempty
syntax match asemeChoice_619 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_617,asemeText_618,@asemeChartNodeInBodyOfStatechart,asemeComment_620 skipwhite skipempty
syntax region asemeComment_620 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_617,asemeText_618,@asemeChartNodeInBodyOfStatechart,asemeComment_620 skipwhite skipempty
syntax match asemeComment_620 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_617,asemeText_618,@asemeChartNodeInBodyOfStatechart,asemeComment_620 skipwhite skipempty
syntax match asemeText_618 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeName_617 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_603,asemeChoice_607,asemeNumber_613,asemeName_615,asemeText_616
syntax match asemeText_616 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeName_615 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeNumber_613 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_611,asemeComment_614 skipwhite skipempty
syntax region asemeComment_614 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_611,asemeComment_614 skipwhite skipempty
syntax match asemeComment_614 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_611,asemeComment_614 skipwhite skipempty
syntax match asemeChoice_611 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_609,asemeText_610,@asemeChartNodeInBodyOfStatechart,asemeComment_612 skipwhite skipempty
syntax region asemeComment_612 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_609,asemeText_610,@asemeChartNodeInBodyOfStatechart,asemeComment_612 skipwhite skipempty
syntax match asemeComment_612 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_609,asemeText_610,@asemeChartNodeInBodyOfStatechart,asemeComment_612 skipwhite skipempty
syntax match asemeText_610 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeName_609 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeChoice_607 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_605,asemeText_606,@asemeChartNodeInBodyOfStatechart,asemeComment_608 skipwhite skipempty
syntax region asemeComment_608 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_605,asemeText_606,@asemeChartNodeInBodyOfStatechart,asemeComment_608 skipwhite skipempty
syntax match asemeComment_608 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_605,asemeText_606,@asemeChartNodeInBodyOfStatechart,asemeComment_608 skipwhite skipempty
syntax match asemeText_606 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeName_605 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeClause_603 /\vactivity%(<|>)/ contained nextgroup=asemeReference_601,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_601,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_601,asemeComment_604 skipwhite skipempty
syntax match asemeReference_601 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax region asemeComment_602 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeComment_602 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_602 skipwhite skipempty
syntax match asemeDeclaration_599 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_598,asemeComment_600 skipwhite skipempty
syntax region asemeComment_600 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_598,asemeComment_600 skipwhite skipempty
syntax match asemeComment_600 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_598,asemeComment_600 skipwhite skipempty
syntax match asemeBlock_598 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_387 skipwhite skipempty
syntax match asemeDeclaration_596 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_594,asemeComment_597 skipwhite skipempty
syntax region asemeComment_597 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_594,asemeComment_597 skipwhite skipempty
syntax match asemeComment_597 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_594,asemeComment_597 skipwhite skipempty
syntax match asemeClause_594 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_593,asemeComment_595 skipwhite skipempty
syntax region asemeComment_595 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_593,asemeComment_595 skipwhite skipempty
syntax match asemeComment_595 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_593,asemeComment_595 skipwhite skipempty
syntax match asemeBlock_593 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_387 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_388,asemePunctuation_591,asemeBlock_592
syntax match asemeBlock_592 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_387 skipwhite skipempty
syntax region asemePunctuation_591 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_396,asemeDeclaration_432,asemeDeclaration_448,asemeDeclaration_470,asemeDeclaration_475,asemeDeclaration_488,asemeDeclaration_530,asemeDeclaration_575,asemeDeclaration_584,asemeDeclaration_589,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_589 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_588,asemeComment_590 skipwhite skipempty
syntax region asemeComment_590 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_588,asemeComment_590 skipwhite skipempty
syntax match asemeComment_590 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_588,asemeComment_590 skipwhite skipempty
syntax match asemeBlock_588 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_587 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_374,asemeBlock_586
syntax match asemeBlock_586 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_587 skipwhite skipempty
syntax region asemeComment_587 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_587 skipwhite skipempty
syntax match asemeComment_587 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_587 skipwhite skipempty
syntax match asemeDeclaration_584 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_583,asemeComment_585 skipwhite skipempty
syntax region asemeComment_585 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_583,asemeComment_585 skipwhite skipempty
syntax match asemeComment_585 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_583,asemeComment_585 skipwhite skipempty
syntax match asemeBlock_583 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_582 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_580,asemeBlock_581
syntax match asemeBlock_581 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_582 skipwhite skipempty
syntax region asemeComment_582 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_582 skipwhite skipempty
syntax match asemeComment_582 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_582 skipwhite skipempty
syntax region asemePunctuation_580 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_578,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_578 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_577,asemeComment_579 skipwhite skipempty
syntax region asemeComment_579 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_577,asemeComment_579 skipwhite skipempty
syntax match asemeComment_579 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_577,asemeComment_579 skipwhite skipempty
syntax match asemeText_577 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_575 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_576 skipwhite skipempty
syntax region asemeComment_576 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_576 skipwhite skipempty
syntax match asemeComment_576 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_576 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_574
syntax region asemePunctuation_574 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_573,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_573 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_537,asemeClause_540,asemeClause_543,asemeClause_546,asemeClause_549,asemeClause_552,asemeClause_555,asemeClause_558,asemeClause_561,asemePunctuation_568,asemeOperator_571
syntax match asemeOperator_571 /\v\=%(\=)@!/ contained nextgroup=asemeText_570,asemeComment_572 skipwhite skipempty
syntax region asemeComment_572 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_570,asemeComment_572 skipwhite skipempty
syntax match asemeComment_572 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_570,asemeComment_572 skipwhite skipempty
syntax match asemeText_570 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemePunctuation_568 /\v\,/ contained nextgroup=asemeChoice_564,asemeReference_566,asemeReference_567,asemeComment_569 skipwhite skipempty
syntax region asemeComment_569 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_564,asemeReference_566,asemeReference_567,asemeComment_569 skipwhite skipempty
syntax match asemeComment_569 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_564,asemeReference_566,asemeReference_567,asemeComment_569 skipwhite skipempty
syntax match asemeReference_567 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeReference_566 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeChoice_564 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_563,asemeComment_565 skipwhite skipempty
syntax region asemeComment_565 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_563,asemeComment_565 skipwhite skipempty
syntax match asemeComment_565 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_563,asemeComment_565 skipwhite skipempty
syntax match asemeReference_563 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_561 /\vends%(<|>)/ contained nextgroup=asemeReference_560,asemeComment_562 skipwhite skipempty
syntax region asemeComment_562 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_560,asemeComment_562 skipwhite skipempty
syntax match asemeComment_562 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_560,asemeComment_562 skipwhite skipempty
syntax match asemeReference_560 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_558 /\vwrites%(<|>)/ contained nextgroup=asemeReference_557,asemeComment_559 skipwhite skipempty
syntax region asemeComment_559 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_557,asemeComment_559 skipwhite skipempty
syntax match asemeComment_559 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_557,asemeComment_559 skipwhite skipempty
syntax match asemeReference_557 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_555 /\vfor%(<|>)/ contained nextgroup=asemeNumber_554,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_554,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_554,asemeComment_556 skipwhite skipempty
syntax match asemeNumber_554 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_552 /\vuses%(<|>)/ contained nextgroup=asemeReference_551,asemeComment_553 skipwhite skipempty
syntax region asemeComment_553 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_551,asemeComment_553 skipwhite skipempty
syntax match asemeComment_553 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_551,asemeComment_553 skipwhite skipempty
syntax match asemeReference_551 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_549 /\vas%(<|>)/ contained nextgroup=asemeChoice_548,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_548,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_548,asemeComment_550 skipwhite skipempty
syntax match asemeChoice_548 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_546 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_545,asemeComment_547 skipwhite skipempty
syntax match asemeNumber_545 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_543 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax match asemeNumber_542 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_540 /\vevery%(<|>)/ contained nextgroup=asemeNumber_539,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_539,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_539,asemeComment_541 skipwhite skipempty
syntax match asemeNumber_539 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeClause_537 /\vreads%(<|>)/ contained nextgroup=asemeChoice_534,asemeReference_536,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_534,asemeReference_536,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_534,asemeReference_536,asemeComment_538 skipwhite skipempty
syntax match asemeReference_536 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeChoice_534 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax region asemeComment_535 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax match asemeComment_535 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_532,asemeComment_535 skipwhite skipempty
syntax match asemeReference_532 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax region asemeComment_533 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeComment_533 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_533 skipwhite skipempty
syntax match asemeDeclaration_530 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_531 skipwhite skipempty
syntax region asemeComment_531 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_531 skipwhite skipempty
syntax match asemeComment_531 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_531 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_529
syntax region asemePunctuation_529 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_528,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_528 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_495,asemeClause_498,asemeClause_501,asemeClause_504,asemeClause_507,asemeClause_510,asemeClause_513,asemeClause_516,asemeClause_519,asemePunctuation_526
syntax match asemePunctuation_526 /\v\,/ contained nextgroup=asemeChoice_522,asemeReference_524,asemeReference_525,asemeComment_527 skipwhite skipempty
syntax region asemeComment_527 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_522,asemeReference_524,asemeReference_525,asemeComment_527 skipwhite skipempty
syntax match asemeComment_527 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_522,asemeReference_524,asemeReference_525,asemeComment_527 skipwhite skipempty
syntax match asemeReference_525 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeReference_524 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeChoice_522 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax region asemeComment_523 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax match asemeComment_523 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_521,asemeComment_523 skipwhite skipempty
syntax match asemeReference_521 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_519 /\vends%(<|>)/ contained nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax region asemeComment_520 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax match asemeComment_520 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_518,asemeComment_520 skipwhite skipempty
syntax match asemeReference_518 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_516 /\vwrites%(<|>)/ contained nextgroup=asemeReference_515,asemeComment_517 skipwhite skipempty
syntax region asemeComment_517 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_515,asemeComment_517 skipwhite skipempty
syntax match asemeComment_517 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_515,asemeComment_517 skipwhite skipempty
syntax match asemeReference_515 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_513 /\vfor%(<|>)/ contained nextgroup=asemeNumber_512,asemeComment_514 skipwhite skipempty
syntax region asemeComment_514 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_512,asemeComment_514 skipwhite skipempty
syntax match asemeComment_514 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_512,asemeComment_514 skipwhite skipempty
syntax match asemeNumber_512 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_510 /\vuses%(<|>)/ contained nextgroup=asemeReference_509,asemeComment_511 skipwhite skipempty
syntax region asemeComment_511 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_509,asemeComment_511 skipwhite skipempty
syntax match asemeComment_511 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_509,asemeComment_511 skipwhite skipempty
syntax match asemeReference_509 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_507 /\vas%(<|>)/ contained nextgroup=asemeChoice_506,asemeComment_508 skipwhite skipempty
syntax region asemeComment_508 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_506,asemeComment_508 skipwhite skipempty
syntax match asemeComment_508 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_506,asemeComment_508 skipwhite skipempty
syntax match asemeChoice_506 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_504 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_503,asemeComment_505 skipwhite skipempty
syntax region asemeComment_505 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_503,asemeComment_505 skipwhite skipempty
syntax match asemeComment_505 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_503,asemeComment_505 skipwhite skipempty
syntax match asemeNumber_503 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_501 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax region asemeComment_502 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax match asemeComment_502 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_500,asemeComment_502 skipwhite skipempty
syntax match asemeNumber_500 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_498 /\vevery%(<|>)/ contained nextgroup=asemeNumber_497,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_497,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_497,asemeComment_499 skipwhite skipempty
syntax match asemeNumber_497 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeClause_495 /\vreads%(<|>)/ contained nextgroup=asemeChoice_492,asemeReference_494,asemeComment_496 skipwhite skipempty
syntax region asemeComment_496 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_492,asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeComment_496 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_492,asemeReference_494,asemeComment_496 skipwhite skipempty
syntax match asemeReference_494 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeChoice_492 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_490,asemeComment_493 skipwhite skipempty
syntax match asemeReference_490 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax region asemeComment_491 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeComment_491 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_491 skipwhite skipempty
syntax match asemeDeclaration_488 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_489 skipwhite skipempty
syntax region asemeComment_489 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_489 skipwhite skipempty
syntax match asemeComment_489 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_489 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_487
syntax region asemePunctuation_487 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_485,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_485 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_484,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_484,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_484,asemeComment_486 skipwhite skipempty
syntax match asemeOperator_484 /\v\=%(\=)@!/ contained nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax cluster asemeFormula contains=asemeText_477,asemeNumber_479,asemeReference_480,asemeNumber_481,asemeOperator_482,asemePunctuation_483
syntax match asemePunctuation_483 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeOperator_482 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeNumber_481 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeReference_480 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeNumber_479 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeText_477 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax region asemeComment_478 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeComment_478 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormula,asemeComment_478 skipwhite skipempty
syntax match asemeDeclaration_475 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_473,asemeComment_476 skipwhite skipempty
syntax region asemeComment_476 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_473,asemeComment_476 skipwhite skipempty
syntax match asemeComment_476 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_473,asemeComment_476 skipwhite skipempty
syntax match asemeName_473 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_472,asemeComment_474 skipwhite skipempty
syntax region asemeComment_474 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_472,asemeComment_474 skipwhite skipempty
syntax match asemeComment_474 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_472,asemeComment_474 skipwhite skipempty
syntax match asemeOperator_472 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_470 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_468,asemeComment_471 skipwhite skipempty
syntax region asemeComment_471 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_468,asemeComment_471 skipwhite skipempty
syntax match asemeComment_471 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_468,asemeComment_471 skipwhite skipempty
syntax match asemeName_468 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_466,asemeComment_469 skipwhite skipempty
syntax region asemeComment_469 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_466,asemeComment_469 skipwhite skipempty
syntax match asemeComment_469 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_466,asemeComment_469 skipwhite skipempty
syntax match asemePunctuation_466 /\v\:/ contained nextgroup=asemeBuiltIn_464,asemeType_465,asemeComment_467 skipwhite skipempty
syntax region asemeComment_467 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_464,asemeType_465,asemeComment_467 skipwhite skipempty
syntax match asemeComment_467 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_464,asemeType_465,asemeComment_467 skipwhite skipempty
syntax match asemeType_465 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeBuiltIn_464 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_453,asemeOperator_455,asemeName_460,asemeBuiltIn_462,asemeType_463
syntax match asemeType_463 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeBuiltIn_462 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeName_460 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_458,asemeComment_461 skipwhite skipempty
syntax region asemeComment_461 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_458,asemeComment_461 skipwhite skipempty
syntax match asemeComment_461 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_458,asemeComment_461 skipwhite skipempty
syntax match asemePunctuation_458 /\v\:/ contained nextgroup=asemeBuiltIn_456,asemeType_457,asemeComment_459 skipwhite skipempty
syntax region asemeComment_459 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_456,asemeType_457,asemeComment_459 skipwhite skipempty
syntax match asemeComment_459 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_456,asemeType_457,asemeComment_459 skipwhite skipempty
syntax match asemeType_457 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeBuiltIn_456 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeOperator_455 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_453 /\v\:/ contained nextgroup=asemeBuiltIn_450,asemeType_452,asemeComment_454 skipwhite skipempty
syntax region asemeComment_454 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_450,asemeType_452,asemeComment_454 skipwhite skipempty
syntax match asemeComment_454 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_450,asemeType_452,asemeComment_454 skipwhite skipempty
syntax match asemeType_452 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeBuiltIn_450 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax region asemeComment_451 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeComment_451 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_451 skipwhite skipempty
syntax match asemeDeclaration_448 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_446,asemeComment_449 skipwhite skipempty
syntax region asemeComment_449 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_446,asemeComment_449 skipwhite skipempty
syntax match asemeComment_449 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_446,asemeComment_449 skipwhite skipempty
syntax match asemeName_446 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_445,@asemeCapabilityInBodyOfSrm,asemeComment_447 skipwhite skipempty
syntax region asemeComment_447 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_445,@asemeCapabilityInBodyOfSrm,asemeComment_447 skipwhite skipempty
syntax match asemeComment_447 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_445,@asemeCapabilityInBodyOfSrm,asemeComment_447 skipwhite skipempty
syntax match asemeText_445 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_436,asemePunctuation_439,asemeText_441,asemeName_443
syntax match asemeName_443 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_442,@asemeCapabilityInBodyOfSrm,asemeComment_444 skipwhite skipempty
syntax region asemeComment_444 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_442,@asemeCapabilityInBodyOfSrm,asemeComment_444 skipwhite skipempty
syntax match asemeComment_444 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_442,@asemeCapabilityInBodyOfSrm,asemeComment_444 skipwhite skipempty
syntax match asemeText_442 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax match asemeText_441 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax match asemePunctuation_439 /\v\,/ contained nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax region asemeComment_440 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax match asemeComment_440 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax match asemeReference_438 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax match asemeOperator_436 /\v\=%(\=)@!/ contained nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax match asemeReference_434 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax region asemeComment_435 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax match asemeComment_435 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_435 skipwhite skipempty
syntax match asemeDeclaration_432 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_430,asemeComment_433 skipwhite skipempty
syntax region asemeComment_433 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_430,asemeComment_433 skipwhite skipempty
syntax match asemeComment_433 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_430,asemeComment_433 skipwhite skipempty
syntax match asemeReference_430 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_428,asemeComment_431 skipwhite skipempty
syntax region asemeComment_431 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_428,asemeComment_431 skipwhite skipempty
syntax match asemeComment_431 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_428,asemeComment_431 skipwhite skipempty
syntax match asemePunctuation_428 /\v\./ contained nextgroup=asemeReference_427,asemeComment_429 skipwhite skipempty
syntax region asemeComment_429 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_427,asemeComment_429 skipwhite skipempty
syntax match asemeComment_429 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_427,asemeComment_429 skipwhite skipempty
syntax match asemeReference_427 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_404,asemeClause_407,asemePunctuation_417,asemePunctuation_420,asemeReference_425
syntax match asemeReference_425 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_423,@asemePlaysInBodyOfSrm,asemeComment_426 skipwhite skipempty
syntax region asemeComment_426 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_423,@asemePlaysInBodyOfSrm,asemeComment_426 skipwhite skipempty
syntax match asemeComment_426 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_423,@asemePlaysInBodyOfSrm,asemeComment_426 skipwhite skipempty
syntax match asemePunctuation_423 /\v\./ contained nextgroup=asemeReference_422,asemeComment_424 skipwhite skipempty
syntax region asemeComment_424 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_422,asemeComment_424 skipwhite skipempty
syntax match asemeComment_424 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_422,asemeComment_424 skipwhite skipempty
syntax match asemeReference_422 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemePunctuation_420 /\v\./ contained nextgroup=asemeReference_419,asemeComment_421 skipwhite skipempty
syntax region asemeComment_421 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_419,asemeComment_421 skipwhite skipempty
syntax match asemeComment_421 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_419,asemeComment_421 skipwhite skipempty
syntax match asemeReference_419 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemePunctuation_417 /\v\,/ contained nextgroup=asemeReference_415,asemeComment_418 skipwhite skipempty
syntax region asemeComment_418 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_415,asemeComment_418 skipwhite skipempty
syntax match asemeComment_418 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_415,asemeComment_418 skipwhite skipempty
syntax match asemeReference_415 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_410,asemePunctuation_413,asemeComment_416 skipwhite skipempty
syntax region asemeComment_416 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_410,asemePunctuation_413,asemeComment_416 skipwhite skipempty
syntax match asemeComment_416 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_410,asemePunctuation_413,asemeComment_416 skipwhite skipempty
syntax match asemePunctuation_413 /\v\./ contained nextgroup=asemeReference_412,asemeComment_414 skipwhite skipempty
syntax region asemeComment_414 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_412,asemeComment_414 skipwhite skipempty
syntax match asemeComment_414 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_412,asemeComment_414 skipwhite skipempty
syntax match asemeReference_412 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeOperator_410 /\v\=%(\=)@!/ contained nextgroup=asemeReference_409,asemeComment_411 skipwhite skipempty
syntax region asemeComment_411 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_409,asemeComment_411 skipwhite skipempty
syntax match asemeComment_411 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_409,asemeComment_411 skipwhite skipempty
syntax match asemeReference_409 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeClause_407 /\vas%(<|>)/ contained nextgroup=asemeReference_406,asemeComment_408 skipwhite skipempty
syntax region asemeComment_408 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_406,asemeComment_408 skipwhite skipempty
syntax match asemeComment_408 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_406,asemeComment_408 skipwhite skipempty
syntax match asemeReference_406 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeClause_404 /\vwith%(<|>)/ contained nextgroup=asemeReference_402,asemeComment_405 skipwhite skipempty
syntax region asemeComment_405 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_402,asemeComment_405 skipwhite skipempty
syntax match asemeComment_405 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_402,asemeComment_405 skipwhite skipempty
syntax match asemeReference_402 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_400,asemeComment_403 skipwhite skipempty
syntax region asemeComment_403 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_400,asemeComment_403 skipwhite skipempty
syntax match asemeComment_403 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_400,asemeComment_403 skipwhite skipempty
syntax match asemeOperator_400 /\v\=%(\=)@!/ contained nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax region asemeComment_401 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax match asemeComment_401 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_398,asemeComment_401 skipwhite skipempty
syntax match asemeReference_398 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax region asemeComment_399 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeComment_399 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_399 skipwhite skipempty
syntax match asemeDeclaration_396 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_395,asemeComment_397 skipwhite skipempty
syntax region asemeComment_397 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_395,asemeComment_397 skipwhite skipempty
syntax match asemeComment_397 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_395,asemeComment_397 skipwhite skipempty
syntax match asemeReference_395 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_391 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_392,asemeReference_394
syntax match asemeReference_394 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_391 skipwhite skipempty
syntax match asemePunctuation_392 /\v\,/ contained nextgroup=asemeReference_390,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_390,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_390,asemeComment_393 skipwhite skipempty
syntax match asemeReference_390 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_391 skipwhite skipempty
syntax region asemeComment_391 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_391 skipwhite skipempty
syntax match asemeComment_391 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_391 skipwhite skipempty
syntax match asemeClause_388 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_386,asemeComment_389 skipwhite skipempty
syntax region asemeComment_389 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_386,asemeComment_389 skipwhite skipempty
syntax match asemeComment_389 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_386,asemeComment_389 skipwhite skipempty
syntax match asemeBlock_386 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_387 skipwhite skipempty
syntax match asemeDeclaration_384 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_383,asemeComment_385 skipwhite skipempty
syntax region asemeComment_385 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_383,asemeComment_385 skipwhite skipempty
syntax match asemeComment_385 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_383,asemeComment_385 skipwhite skipempty
syntax match asemeBlock_383 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_382 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_380,asemeBlock_381
syntax match asemeBlock_381 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_382 skipwhite skipempty
syntax region asemeComment_382 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_382 skipwhite skipempty
syntax match asemeComment_382 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_382 skipwhite skipempty
syntax region asemePunctuation_380 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_284,asemeDeclaration_287,asemeDeclaration_315,asemeDeclaration_319,asemeDeclaration_378,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_378 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_377,asemeComment_379 skipwhite skipempty
syntax region asemeComment_379 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_377,asemeComment_379 skipwhite skipempty
syntax match asemeComment_379 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_377,asemeComment_379 skipwhite skipempty
syntax match asemeBlock_377 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_376 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_374,asemeBlock_375
syntax match asemeBlock_375 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_376 skipwhite skipempty
syntax region asemeComment_376 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_376 skipwhite skipempty
syntax match asemeComment_376 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_376 skipwhite skipempty
syntax region asemePunctuation_374 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_349,asemeNumber_372,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeNumber_372 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_370,asemeComment_373 skipwhite skipempty
syntax region asemeComment_373 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_370,asemeComment_373 skipwhite skipempty
syntax match asemeComment_373 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_370,asemeComment_373 skipwhite skipempty
syntax match asemeOperator_370 /\v\-\>/ contained nextgroup=asemeNumber_368,asemeComment_371 skipwhite skipempty
syntax region asemeComment_371 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_368,asemeComment_371 skipwhite skipempty
syntax match asemeComment_371 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_368,asemeComment_371 skipwhite skipempty
syntax match asemeNumber_368 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_367,asemeComment_369 skipwhite skipempty
syntax region asemeComment_369 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_367,asemeComment_369 skipwhite skipempty
syntax match asemeComment_369 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_367,asemeComment_369 skipwhite skipempty
syntax match asemePunctuation_367 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeText_350,asemeNumber_352,asemeTruth_353,asemeLogic_354,asemeClause_355,asemeClause_356,asemeClause_357,asemeClause_358,asemeClause_359,asemeClause_360,asemeClause_361,asemeClause_362,asemeCall_363,asemeReference_364,asemeOperator_365,asemePunctuation_366
syntax match asemePunctuation_366 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeOperator_365 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeReference_364 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeCall_363 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_362 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_361 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_360 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_359 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_358 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_357 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_356 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeClause_355 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeLogic_354 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeTruth_353 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeNumber_352 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeText_350 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax region asemeComment_351 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeComment_351 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_351 skipwhite skipempty
syntax match asemeDeclaration_349 /\v%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeOperator_323,asemePunctuation_342,asemeText_343,asemeNumber_344,asemeReference_345,asemeNumber_346,asemeOperator_347,asemePunctuation_348
syntax match asemePunctuation_348 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeOperator_347 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeNumber_346 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeReference_345 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeNumber_344 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemeText_343 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\-%(\>)@!|[.|()\[\]~*+&;,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
syntax match asemePunctuation_342 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeText_325,asemeNumber_327,asemeTruth_328,asemeLogic_329,asemeClause_330,asemeClause_331,asemeClause_332,asemeClause_333,asemeClause_334,asemeClause_335,asemeClause_336,asemeClause_337,asemeCall_338,asemeReference_339,asemeOperator_340,asemePunctuation_341
syntax match asemePunctuation_341 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeOperator_340 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeReference_339 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeCall_338 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_337 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_336 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_335 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_334 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_333 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_332 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_331 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeClause_330 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeLogic_329 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeTruth_328 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeNumber_327 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeText_325 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax region asemeComment_326 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeComment_326 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_326 skipwhite skipempty
syntax match asemeOperator_323 /\v\#/ contained nextgroup=asemeNumber_321,asemeComment_324 skipwhite skipempty
syntax region asemeComment_324 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_321,asemeComment_324 skipwhite skipempty
syntax match asemeComment_324 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_321,asemeComment_324 skipwhite skipempty
syntax match asemeNumber_321 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_322 skipwhite skipempty
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
highlight default link asemeBlock_375 asemeBlock
highlight default link asemeBlock_377 asemeBlock
highlight default link asemeBlock_381 asemeBlock
highlight default link asemeBlock_383 asemeBlock
highlight default link asemeBlock_386 asemeBlock
highlight default link asemeBlock_45 asemeBlock
highlight default link asemeBlock_47 asemeBlock
highlight default link asemeBlock_581 asemeBlock
highlight default link asemeBlock_583 asemeBlock
highlight default link asemeBlock_586 asemeBlock
highlight default link asemeBlock_588 asemeBlock
highlight default link asemeBlock_592 asemeBlock
highlight default link asemeBlock_593 asemeBlock
highlight default link asemeBlock_598 asemeBlock
highlight default link asemeBlock_664 asemeBlock
highlight default link asemeBlock_666 asemeBlock
highlight default link asemeBlock_687 asemeBlock
highlight default link asemeBlock_689 asemeBlock
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
highlight default link asemeBuiltIn_450 asemeBuiltIn
highlight default link asemeBuiltIn_456 asemeBuiltIn
highlight default link asemeBuiltIn_462 asemeBuiltIn
highlight default link asemeBuiltIn_464 asemeBuiltIn
highlight default link asemeBuiltIn_56 asemeBuiltIn
highlight default link asemeBuiltIn_61 asemeBuiltIn
highlight default link asemeBuiltIn_632 asemeBuiltIn
highlight default link asemeBuiltIn_638 asemeBuiltIn
highlight default link asemeBuiltIn_644 asemeBuiltIn
highlight default link asemeBuiltIn_646 asemeBuiltIn
highlight default link asemeBuiltIn_67 asemeBuiltIn
highlight default link asemeCall_217 asemeCall
highlight default link asemeCall_23 asemeCall
highlight default link asemeCall_338 asemeCall
highlight default link asemeCall_363 asemeCall
highlight default link asemeChoice_160 asemeChoice
highlight default link asemeChoice_289 asemeChoice
highlight default link asemeChoice_492 asemeChoice
highlight default link asemeChoice_506 asemeChoice
highlight default link asemeChoice_522 asemeChoice
highlight default link asemeChoice_534 asemeChoice
highlight default link asemeChoice_548 asemeChoice
highlight default link asemeChoice_564 asemeChoice
highlight default link asemeChoice_607 asemeChoice
highlight default link asemeChoice_611 asemeChoice
highlight default link asemeChoice_619 asemeChoice
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
highlight default link asemeClause_330 asemeClause
highlight default link asemeClause_331 asemeClause
highlight default link asemeClause_332 asemeClause
highlight default link asemeClause_333 asemeClause
highlight default link asemeClause_334 asemeClause
highlight default link asemeClause_335 asemeClause
highlight default link asemeClause_336 asemeClause
highlight default link asemeClause_337 asemeClause
highlight default link asemeClause_355 asemeClause
highlight default link asemeClause_356 asemeClause
highlight default link asemeClause_357 asemeClause
highlight default link asemeClause_358 asemeClause
highlight default link asemeClause_359 asemeClause
highlight default link asemeClause_360 asemeClause
highlight default link asemeClause_361 asemeClause
highlight default link asemeClause_362 asemeClause
highlight default link asemeClause_388 asemeClause
highlight default link asemeClause_404 asemeClause
highlight default link asemeClause_407 asemeClause
highlight default link asemeClause_495 asemeClause
highlight default link asemeClause_498 asemeClause
highlight default link asemeClause_501 asemeClause
highlight default link asemeClause_504 asemeClause
highlight default link asemeClause_507 asemeClause
highlight default link asemeClause_510 asemeClause
highlight default link asemeClause_513 asemeClause
highlight default link asemeClause_516 asemeClause
highlight default link asemeClause_519 asemeClause
highlight default link asemeClause_537 asemeClause
highlight default link asemeClause_540 asemeClause
highlight default link asemeClause_543 asemeClause
highlight default link asemeClause_546 asemeClause
highlight default link asemeClause_549 asemeClause
highlight default link asemeClause_552 asemeClause
highlight default link asemeClause_555 asemeClause
highlight default link asemeClause_558 asemeClause
highlight default link asemeClause_561 asemeClause
highlight default link asemeClause_594 asemeClause
highlight default link asemeClause_603 asemeClause
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
highlight default link asemeComment_326 asemeComment
highlight default link asemeComment_33 asemeComment
highlight default link asemeComment_35 asemeComment
highlight default link asemeComment_351 asemeComment
highlight default link asemeComment_369 asemeComment
highlight default link asemeComment_371 asemeComment
highlight default link asemeComment_373 asemeComment
highlight default link asemeComment_376 asemeComment
highlight default link asemeComment_379 asemeComment
highlight default link asemeComment_382 asemeComment
highlight default link asemeComment_385 asemeComment
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_389 asemeComment
highlight default link asemeComment_391 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_397 asemeComment
highlight default link asemeComment_399 asemeComment
highlight default link asemeComment_401 asemeComment
highlight default link asemeComment_403 asemeComment
highlight default link asemeComment_405 asemeComment
highlight default link asemeComment_408 asemeComment
highlight default link asemeComment_411 asemeComment
highlight default link asemeComment_414 asemeComment
highlight default link asemeComment_416 asemeComment
highlight default link asemeComment_418 asemeComment
highlight default link asemeComment_421 asemeComment
highlight default link asemeComment_424 asemeComment
highlight default link asemeComment_426 asemeComment
highlight default link asemeComment_429 asemeComment
highlight default link asemeComment_431 asemeComment
highlight default link asemeComment_433 asemeComment
highlight default link asemeComment_435 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_440 asemeComment
highlight default link asemeComment_444 asemeComment
highlight default link asemeComment_447 asemeComment
highlight default link asemeComment_449 asemeComment
highlight default link asemeComment_451 asemeComment
highlight default link asemeComment_454 asemeComment
highlight default link asemeComment_459 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_461 asemeComment
highlight default link asemeComment_467 asemeComment
highlight default link asemeComment_469 asemeComment
highlight default link asemeComment_471 asemeComment
highlight default link asemeComment_474 asemeComment
highlight default link asemeComment_476 asemeComment
highlight default link asemeComment_478 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_489 asemeComment
highlight default link asemeComment_49 asemeComment
highlight default link asemeComment_491 asemeComment
highlight default link asemeComment_493 asemeComment
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
highlight default link asemeComment_527 asemeComment
highlight default link asemeComment_53 asemeComment
highlight default link asemeComment_531 asemeComment
highlight default link asemeComment_533 asemeComment
highlight default link asemeComment_535 asemeComment
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
highlight default link asemeComment_569 asemeComment
highlight default link asemeComment_57 asemeComment
highlight default link asemeComment_572 asemeComment
highlight default link asemeComment_576 asemeComment
highlight default link asemeComment_579 asemeComment
highlight default link asemeComment_582 asemeComment
highlight default link asemeComment_585 asemeComment
highlight default link asemeComment_587 asemeComment
highlight default link asemeComment_590 asemeComment
highlight default link asemeComment_595 asemeComment
highlight default link asemeComment_597 asemeComment
highlight default link asemeComment_600 asemeComment
highlight default link asemeComment_602 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_608 asemeComment
highlight default link asemeComment_612 asemeComment
highlight default link asemeComment_614 asemeComment
highlight default link asemeComment_62 asemeComment
highlight default link asemeComment_620 asemeComment
highlight default link asemeComment_622 asemeComment
highlight default link asemeComment_624 asemeComment
highlight default link asemeComment_627 asemeComment
highlight default link asemeComment_629 asemeComment
highlight default link asemeComment_631 asemeComment
highlight default link asemeComment_633 asemeComment
highlight default link asemeComment_636 asemeComment
highlight default link asemeComment_641 asemeComment
highlight default link asemeComment_643 asemeComment
highlight default link asemeComment_649 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_651 asemeComment
highlight default link asemeComment_653 asemeComment
highlight default link asemeComment_656 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_660 asemeComment
highlight default link asemeComment_662 asemeComment
highlight default link asemeComment_665 asemeComment
highlight default link asemeComment_668 asemeComment
highlight default link asemeComment_670 asemeComment
highlight default link asemeComment_672 asemeComment
highlight default link asemeComment_674 asemeComment
highlight default link asemeComment_676 asemeComment
highlight default link asemeComment_678 asemeComment
highlight default link asemeComment_68 asemeComment
highlight default link asemeComment_681 asemeComment
highlight default link asemeComment_684 asemeComment
highlight default link asemeComment_688 asemeComment
highlight default link asemeComment_691 asemeComment
highlight default link asemeComment_717 asemeComment
highlight default link asemeComment_72 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_728 asemeComment
highlight default link asemeComment_731 asemeComment
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
highlight default link asemeDeclaration_349 asemeDeclaration
highlight default link asemeDeclaration_378 asemeDeclaration
highlight default link asemeDeclaration_384 asemeDeclaration
highlight default link asemeDeclaration_396 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_432 asemeDeclaration
highlight default link asemeDeclaration_448 asemeDeclaration
highlight default link asemeDeclaration_470 asemeDeclaration
highlight default link asemeDeclaration_475 asemeDeclaration
highlight default link asemeDeclaration_48 asemeDeclaration
highlight default link asemeDeclaration_488 asemeDeclaration
highlight default link asemeDeclaration_530 asemeDeclaration
highlight default link asemeDeclaration_575 asemeDeclaration
highlight default link asemeDeclaration_578 asemeDeclaration
highlight default link asemeDeclaration_584 asemeDeclaration
highlight default link asemeDeclaration_589 asemeDeclaration
highlight default link asemeDeclaration_596 asemeDeclaration
highlight default link asemeDeclaration_599 asemeDeclaration
highlight default link asemeDeclaration_623 asemeDeclaration
highlight default link asemeDeclaration_64 asemeDeclaration
highlight default link asemeDeclaration_652 asemeDeclaration
highlight default link asemeDeclaration_657 asemeDeclaration
highlight default link asemeDeclaration_659 asemeDeclaration
highlight default link asemeDeclaration_661 asemeDeclaration
highlight default link asemeDeclaration_667 asemeDeclaration
highlight default link asemeDeclaration_690 asemeDeclaration
highlight default link asemeDeclaration_719 asemeDeclaration
highlight default link asemeDeclaration_730 asemeDeclaration
highlight default link asemeDeclaration_74 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_96 asemeDeclaration
highlight default link asemeLogic_14 asemeLogic
highlight default link asemeLogic_208 asemeLogic
highlight default link asemeLogic_329 asemeLogic
highlight default link asemeLogic_354 asemeLogic
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
highlight default link asemeName_443 asemeName
highlight default link asemeName_446 asemeName
highlight default link asemeName_460 asemeName
highlight default link asemeName_468 asemeName
highlight default link asemeName_473 asemeName
highlight default link asemeName_485 asemeName
highlight default link asemeName_528 asemeName
highlight default link asemeName_55 asemeName
highlight default link asemeName_573 asemeName
highlight default link asemeName_59 asemeName
highlight default link asemeName_60 asemeName
highlight default link asemeName_605 asemeName
highlight default link asemeName_609 asemeName
highlight default link asemeName_615 asemeName
highlight default link asemeName_617 asemeName
highlight default link asemeName_642 asemeName
highlight default link asemeName_650 asemeName
highlight default link asemeName_655 asemeName
highlight default link asemeName_66 asemeName
highlight default link asemeName_679 asemeName
highlight default link asemeName_685 asemeName
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
highlight default link asemeNumber_327 asemeNumber
highlight default link asemeNumber_344 asemeNumber
highlight default link asemeNumber_346 asemeNumber
highlight default link asemeNumber_352 asemeNumber
highlight default link asemeNumber_368 asemeNumber
highlight default link asemeNumber_372 asemeNumber
highlight default link asemeNumber_40 asemeNumber
highlight default link asemeNumber_479 asemeNumber
highlight default link asemeNumber_481 asemeNumber
highlight default link asemeNumber_497 asemeNumber
highlight default link asemeNumber_50 asemeNumber
highlight default link asemeNumber_500 asemeNumber
highlight default link asemeNumber_503 asemeNumber
highlight default link asemeNumber_512 asemeNumber
highlight default link asemeNumber_539 asemeNumber
highlight default link asemeNumber_542 asemeNumber
highlight default link asemeNumber_545 asemeNumber
highlight default link asemeNumber_554 asemeNumber
highlight default link asemeNumber_613 asemeNumber
highlight default link asemeNumber_621 asemeNumber
highlight default link asemeNumber_626 asemeNumber
highlight default link asemeNumber_630 asemeNumber
highlight default link asemeNumber_671 asemeNumber
highlight default link asemeNumber_675 asemeNumber
highlight default link asemeNumber_693 asemeNumber
highlight default link asemeNumber_699 asemeNumber
highlight default link asemeNumber_705 asemeNumber
highlight default link asemeNumber_711 asemeNumber
highlight default link asemeNumber_722 asemeNumber
highlight default link asemeNumber_734 asemeNumber
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
highlight default link asemeOperator_323 asemeOperator
highlight default link asemeOperator_34 asemeOperator
highlight default link asemeOperator_340 asemeOperator
highlight default link asemeOperator_347 asemeOperator
highlight default link asemeOperator_365 asemeOperator
highlight default link asemeOperator_370 asemeOperator
highlight default link asemeOperator_400 asemeOperator
highlight default link asemeOperator_410 asemeOperator
highlight default link asemeOperator_436 asemeOperator
highlight default link asemeOperator_455 asemeOperator
highlight default link asemeOperator_472 asemeOperator
highlight default link asemeOperator_482 asemeOperator
highlight default link asemeOperator_484 asemeOperator
highlight default link asemeOperator_52 asemeOperator
highlight default link asemeOperator_571 asemeOperator
highlight default link asemeOperator_628 asemeOperator
highlight default link asemeOperator_637 asemeOperator
highlight default link asemeOperator_654 asemeOperator
highlight default link asemeOperator_695 asemeOperator
highlight default link asemeOperator_701 asemeOperator
highlight default link asemeOperator_707 asemeOperator
highlight default link asemeOperator_713 asemeOperator
highlight default link asemeOperator_724 asemeOperator
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
highlight default link asemePunctuation_341 asemePunctuation
highlight default link asemePunctuation_342 asemePunctuation
highlight default link asemePunctuation_348 asemePunctuation
highlight default link asemePunctuation_36 asemePunctuation
highlight default link asemePunctuation_366 asemePunctuation
highlight default link asemePunctuation_367 asemePunctuation
highlight default link asemePunctuation_374 asemePunctuation
highlight default link asemePunctuation_380 asemePunctuation
highlight default link asemePunctuation_392 asemePunctuation
highlight default link asemePunctuation_413 asemePunctuation
highlight default link asemePunctuation_417 asemePunctuation
highlight default link asemePunctuation_420 asemePunctuation
highlight default link asemePunctuation_423 asemePunctuation
highlight default link asemePunctuation_428 asemePunctuation
highlight default link asemePunctuation_43 asemePunctuation
highlight default link asemePunctuation_439 asemePunctuation
highlight default link asemePunctuation_44 asemePunctuation
highlight default link asemePunctuation_453 asemePunctuation
highlight default link asemePunctuation_458 asemePunctuation
highlight default link asemePunctuation_466 asemePunctuation
highlight default link asemePunctuation_483 asemePunctuation
highlight default link asemePunctuation_487 asemePunctuation
highlight default link asemePunctuation_526 asemePunctuation
highlight default link asemePunctuation_529 asemePunctuation
highlight default link asemePunctuation_54 asemePunctuation
highlight default link asemePunctuation_568 asemePunctuation
highlight default link asemePunctuation_574 asemePunctuation
highlight default link asemePunctuation_580 asemePunctuation
highlight default link asemePunctuation_591 asemePunctuation
highlight default link asemePunctuation_625 asemePunctuation
highlight default link asemePunctuation_635 asemePunctuation
highlight default link asemePunctuation_640 asemePunctuation
highlight default link asemePunctuation_648 asemePunctuation
highlight default link asemePunctuation_663 asemePunctuation
highlight default link asemePunctuation_669 asemePunctuation
highlight default link asemePunctuation_673 asemePunctuation
highlight default link asemePunctuation_677 asemePunctuation
highlight default link asemePunctuation_680 asemePunctuation
highlight default link asemePunctuation_683 asemePunctuation
highlight default link asemePunctuation_686 asemePunctuation
highlight default link asemePunctuation_696 asemePunctuation
highlight default link asemePunctuation_697 asemePunctuation
highlight default link asemePunctuation_70 asemePunctuation
highlight default link asemePunctuation_702 asemePunctuation
highlight default link asemePunctuation_703 asemePunctuation
highlight default link asemePunctuation_708 asemePunctuation
highlight default link asemePunctuation_709 asemePunctuation
highlight default link asemePunctuation_714 asemePunctuation
highlight default link asemePunctuation_715 asemePunctuation
highlight default link asemePunctuation_725 asemePunctuation
highlight default link asemePunctuation_726 asemePunctuation
highlight default link asemePunctuation_737 asemePunctuation
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
highlight default link asemeReference_339 asemeReference
highlight default link asemeReference_345 asemeReference
highlight default link asemeReference_364 asemeReference
highlight default link asemeReference_390 asemeReference
highlight default link asemeReference_394 asemeReference
highlight default link asemeReference_395 asemeReference
highlight default link asemeReference_398 asemeReference
highlight default link asemeReference_402 asemeReference
highlight default link asemeReference_406 asemeReference
highlight default link asemeReference_409 asemeReference
highlight default link asemeReference_41 asemeReference
highlight default link asemeReference_412 asemeReference
highlight default link asemeReference_415 asemeReference
highlight default link asemeReference_419 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_422 asemeReference
highlight default link asemeReference_425 asemeReference
highlight default link asemeReference_427 asemeReference
highlight default link asemeReference_430 asemeReference
highlight default link asemeReference_434 asemeReference
highlight default link asemeReference_438 asemeReference
highlight default link asemeReference_480 asemeReference
highlight default link asemeReference_490 asemeReference
highlight default link asemeReference_494 asemeReference
highlight default link asemeReference_509 asemeReference
highlight default link asemeReference_515 asemeReference
highlight default link asemeReference_518 asemeReference
highlight default link asemeReference_521 asemeReference
highlight default link asemeReference_524 asemeReference
highlight default link asemeReference_525 asemeReference
highlight default link asemeReference_532 asemeReference
highlight default link asemeReference_536 asemeReference
highlight default link asemeReference_551 asemeReference
highlight default link asemeReference_557 asemeReference
highlight default link asemeReference_560 asemeReference
highlight default link asemeReference_563 asemeReference
highlight default link asemeReference_566 asemeReference
highlight default link asemeReference_567 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_601 asemeReference
highlight default link asemeReference_682 asemeReference
highlight default link asemeReference_694 asemeReference
highlight default link asemeReference_700 asemeReference
highlight default link asemeReference_706 asemeReference
highlight default link asemeReference_712 asemeReference
highlight default link asemeReference_723 asemeReference
highlight default link asemeReference_735 asemeReference
highlight default link asemeReference_736 asemeReference
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
highlight default link asemeText_325 asemeText
highlight default link asemeText_343 asemeText
highlight default link asemeText_350 asemeText
highlight default link asemeText_38 asemeText
highlight default link asemeText_39 asemeText
highlight default link asemeText_441 asemeText
highlight default link asemeText_442 asemeText
highlight default link asemeText_445 asemeText
highlight default link asemeText_477 asemeText
highlight default link asemeText_570 asemeText
highlight default link asemeText_577 asemeText
highlight default link asemeText_606 asemeText
highlight default link asemeText_610 asemeText
highlight default link asemeText_616 asemeText
highlight default link asemeText_618 asemeText
highlight default link asemeText_692 asemeText
highlight default link asemeText_698 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_704 asemeText
highlight default link asemeText_710 asemeText
highlight default link asemeText_716 asemeText
highlight default link asemeText_718 asemeText
highlight default link asemeText_721 asemeText
highlight default link asemeText_727 asemeText
highlight default link asemeText_729 asemeText
highlight default link asemeText_732 asemeText
highlight default link asemeText_733 asemeText
highlight default link asemeTruth_13 asemeTruth
highlight default link asemeTruth_207 asemeTruth
highlight default link asemeTruth_328 asemeTruth
highlight default link asemeTruth_353 asemeTruth
highlight default link asemeType_109 asemeType
highlight default link asemeType_117 asemeType
highlight default link asemeType_124 asemeType
highlight default link asemeType_201 asemeType
highlight default link asemeType_223 asemeType
highlight default link asemeType_229 asemeType
highlight default link asemeType_231 asemeType
highlight default link asemeType_452 asemeType
highlight default link asemeType_457 asemeType
highlight default link asemeType_463 asemeType
highlight default link asemeType_465 asemeType
highlight default link asemeType_58 asemeType
highlight default link asemeType_63 asemeType
highlight default link asemeType_634 asemeType
highlight default link asemeType_639 asemeType
highlight default link asemeType_645 asemeType
highlight default link asemeType_647 asemeType
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
