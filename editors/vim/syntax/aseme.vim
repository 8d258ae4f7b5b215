" Vim syntax of ASEME. Made from aseme_dsl/grammar/*.tx: python3 dev.py syntax
" The name of a group begins with the kind of its token: asemeClause_12 is the word of a clause.
if exists("b:current_syntax")
  finish
endif
scriptencoding utf-8
syntax sync fromstart
syntax match asemeReference_786 /\v[^ \t0-9A-Za-z_{}]/
syntax match asemeReference_785 /\v\w+/
syntax match asemeNumber_784 /\v[0-9]+%(\.[0-9]+)*\w*/
syntax match asemeText_783 /\v\"[^"\n]*/ contains=@Spell
syntax match asemeText_782 /\v\"%([^"\\\n]|\\.)*\"/ contains=@Spell
syntax region asemePunctuation_787 matchgroup=asemePunctuation start=/{/ end=/}/ contains=@asemeStrayTrue transparent
syntax cluster asemeStrayTrue contains=asemeText_782,asemeText_783,asemeNumber_784,asemeReference_785,asemeReference_786,asemePunctuation_787,asemeComment
syntax match asemeReference_42 /\v[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeReference_41 /\v\w+/ contained
syntax match asemeNumber_40 /\v[0-9]+%(\.[0-9]+)*\w*/ contained
syntax match asemeText_39 /\v\"[^"\n]*/ contained contains=@Spell
syntax match asemeText_38 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_43 matchgroup=asemePunctuation start=/{/ end=/}/ contained contains=@asemeStrayFalse transparent
syntax cluster asemeStrayFalse contains=asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax cluster asemeFile contains=asemeDeclaration_1,asemeDeclaration_4,asemeDeclaration_8,asemeDeclaration_30,asemeDeclaration_48,asemeDeclaration_74,asemeDeclaration_101,asemeDeclaration_131,asemeDeclaration_154,asemeDeclaration_186,asemeDeclaration_403,asemeDeclaration_646,asemeDeclaration_649,asemeDeclaration_717,asemeDeclaration_740,asemeDeclaration_769,asemeDeclaration_780,asemeText_782,asemeText_783,asemeNumber_784,asemeReference_785,asemeReference_786,asemePunctuation_787,asemeComment
syntax match asemeDeclaration_780 /\v%(property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=property%(<|>)/ nextgroup=asemeText_779,asemeComment_781 skipwhite skipempty
syntax region asemeComment_781 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_779,asemeComment_781 skipwhite skipempty
syntax match asemeComment_781 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_779,asemeComment_781 skipwhite skipempty
syntax match asemeText_779 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_778 skipwhite skipempty
syntax cluster asemePropertyInFile contains=asemePunctuation_776,asemeText_777
syntax match asemeText_777 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_778 skipwhite skipempty
syntax region asemeComment_778 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_778 skipwhite skipempty
syntax match asemeComment_778 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePropertyInFile,asemeComment_778 skipwhite skipempty
syntax region asemePunctuation_776 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfProperty
syntax cluster asemeBodyOfProperty contains=asemePunctuation_759,asemeText_771,asemeNumber_772,asemeReference_773,asemeOperator_774,asemePunctuation_775,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_775 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_774 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_773 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_772 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_771 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_769 /\v%(scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=scenario%(<|>)/ nextgroup=asemeText_768,asemeComment_770 skipwhite skipempty
syntax region asemeComment_770 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_768,asemeComment_770 skipwhite skipempty
syntax match asemeComment_770 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_768,asemeComment_770 skipwhite skipempty
syntax match asemeText_768 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_767 skipwhite skipempty
syntax cluster asemeScenarioInFile contains=asemePunctuation_765,asemeText_766
syntax match asemeText_766 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_767 skipwhite skipempty
syntax region asemeComment_767 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_767 skipwhite skipempty
syntax match asemeComment_767 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeScenarioInFile,asemeComment_767 skipwhite skipempty
syntax region asemePunctuation_765 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfScenario
syntax cluster asemeBodyOfScenario contains=asemePunctuation_759,asemeText_760,asemeNumber_761,asemeReference_762,asemeOperator_763,asemePunctuation_764,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_764 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_763 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_762 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_761 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_760 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_759 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced
syntax cluster asemeBodyOfBraced contains=asemePunctuation_753,asemeText_754,asemeNumber_755,asemeReference_756,asemeOperator_757,asemePunctuation_758,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_758 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_757 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_756 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_755 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_754 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_753 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced2
syntax cluster asemeBodyOfBraced2 contains=asemePunctuation_747,asemeText_748,asemeNumber_749,asemeReference_750,asemeOperator_751,asemePunctuation_752,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_752 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_751 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_750 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_749 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_748 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax region asemePunctuation_747 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfBraced3
syntax cluster asemeBodyOfBraced3 contains=asemeText_742,asemeNumber_743,asemeReference_744,asemeOperator_745,asemePunctuation_746,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemePunctuation_746 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained
syntax match asemeOperator_745 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained
syntax match asemeReference_744 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained
syntax match asemeNumber_743 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained
syntax match asemeText_742 /\v%(%(%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\.[A-Za-z_][A-Za-z0-9_]*)*|\&\&|\|\||[<>=!]\=|\-\>|\.\.|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_740 /\v%(team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=team%(<|>)/ nextgroup=asemeBlock_739,asemeComment_741 skipwhite skipempty
syntax region asemeComment_741 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_739,asemeComment_741 skipwhite skipempty
syntax match asemeComment_741 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_739,asemeComment_741 skipwhite skipempty
syntax match asemeBlock_739 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_738 skipwhite skipempty
syntax cluster asemeTeamInFile contains=asemePunctuation_736,asemeBlock_737
syntax match asemeBlock_737 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeTeamInFile,asemeComment_738 skipwhite skipempty
syntax region asemeComment_738 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_738 skipwhite skipempty
syntax match asemeComment_738 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeTeamInFile,asemeComment_738 skipwhite skipempty
syntax region asemePunctuation_736 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfTeam
syntax cluster asemeBodyOfTeam contains=asemeName_735,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_735 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[\[,:])@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_720 skipwhite skipempty
syntax cluster asemeAgentsInBodyOfTeam contains=asemePunctuation_727,asemePunctuation_730,asemePunctuation_733
syntax match asemePunctuation_733 /\v\:/ contained nextgroup=asemeReference_732,asemeComment_734 skipwhite skipempty
syntax region asemeComment_734 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_732,asemeComment_734 skipwhite skipempty
syntax match asemeComment_734 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_732,asemeComment_734 skipwhite skipempty
syntax match asemeReference_732 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[\[:,])@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_720 skipwhite skipempty
syntax match asemePunctuation_730 /\v\,/ contained nextgroup=asemeName_729,asemeComment_731 skipwhite skipempty
syntax region asemeComment_731 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_729,asemeComment_731 skipwhite skipempty
syntax match asemeComment_731 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_729,asemeComment_731 skipwhite skipempty
syntax match asemeName_729 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_720 skipwhite skipempty
syntax match asemePunctuation_727 /\v\[/ contained nextgroup=asemeNumber_725,asemeComment_728 skipwhite skipempty
syntax region asemeComment_728 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_725,asemeComment_728 skipwhite skipempty
syntax match asemeComment_728 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_725,asemeComment_728 skipwhite skipempty
syntax match asemeNumber_725 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_723,asemeComment_726 skipwhite skipempty
syntax region asemeComment_726 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_723,asemeComment_726 skipwhite skipempty
syntax match asemeComment_726 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_723,asemeComment_726 skipwhite skipempty
syntax match asemePunctuation_723 /\v\.\./ contained nextgroup=asemeNumber_721,asemeComment_724 skipwhite skipempty
syntax region asemeComment_724 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_721,asemeComment_724 skipwhite skipempty
syntax match asemeComment_724 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_721,asemeComment_724 skipwhite skipempty
syntax match asemeNumber_721 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=asemePunctuation_719,asemeComment_722 skipwhite skipempty
syntax region asemeComment_722 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_719,asemeComment_722 skipwhite skipempty
syntax match asemeComment_722 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_719,asemeComment_722 skipwhite skipempty
syntax match asemePunctuation_719 /\v\]/ contained nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_720 skipwhite skipempty
syntax region asemeComment_720 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_720 skipwhite skipempty
syntax match asemeComment_720 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAgentsInBodyOfTeam,asemeComment_720 skipwhite skipempty
syntax match asemeDeclaration_717 /\v%(statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=statechart%(<|>)/ nextgroup=asemeBlock_716,asemeComment_718 skipwhite skipempty
syntax region asemeComment_718 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_716,asemeComment_718 skipwhite skipempty
syntax match asemeComment_718 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_716,asemeComment_718 skipwhite skipempty
syntax match asemeBlock_716 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_715 skipwhite skipempty
syntax cluster asemeStatechartInFile contains=asemePunctuation_713,asemeBlock_714
syntax match asemeBlock_714 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeStatechartInFile,asemeComment_715 skipwhite skipempty
syntax region asemeComment_715 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_715 skipwhite skipempty
syntax match asemeComment_715 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeStatechartInFile,asemeComment_715 skipwhite skipempty
syntax region asemePunctuation_713 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfStatechart
syntax cluster asemeBodyOfStatechart contains=asemeDeclaration_673,asemeNumber_680,asemeDeclaration_702,asemeDeclaration_707,asemeDeclaration_709,asemeDeclaration_711,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_711 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_712 skipwhite skipempty
syntax region asemeComment_712 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_712 skipwhite skipempty
syntax match asemeComment_712 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfStatechart,asemeComment_712 skipwhite skipempty
syntax cluster asemeModulesInBodyOfStatechart contains=asemePunctuation_619
syntax match asemeDeclaration_709 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_710 skipwhite skipempty
syntax region asemeComment_710 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_710 skipwhite skipempty
syntax match asemeComment_710 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfStatechart,asemeComment_710 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfStatechart contains=asemePunctuation_574
syntax match asemeDeclaration_707 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_705,asemeComment_708 skipwhite skipempty
syntax region asemeComment_708 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_705,asemeComment_708 skipwhite skipempty
syntax match asemeComment_708 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_705,asemeComment_708 skipwhite skipempty
syntax match asemeName_705 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_704,asemeComment_706 skipwhite skipempty
syntax region asemeComment_706 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_704,asemeComment_706 skipwhite skipempty
syntax match asemeComment_706 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_704,asemeComment_706 skipwhite skipempty
syntax match asemeOperator_704 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_702 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_700,asemeComment_703 skipwhite skipempty
syntax region asemeComment_703 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_700,asemeComment_703 skipwhite skipempty
syntax match asemeComment_703 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_700,asemeComment_703 skipwhite skipempty
syntax match asemeName_700 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_698,asemeComment_701 skipwhite skipempty
syntax region asemeComment_701 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_698,asemeComment_701 skipwhite skipempty
syntax match asemeComment_701 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_698,asemeComment_701 skipwhite skipempty
syntax match asemePunctuation_698 /\v\:/ contained nextgroup=asemeBuiltIn_696,asemeType_697,asemeComment_699 skipwhite skipempty
syntax region asemeComment_699 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_696,asemeType_697,asemeComment_699 skipwhite skipempty
syntax match asemeComment_699 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_696,asemeType_697,asemeComment_699 skipwhite skipempty
syntax match asemeType_697 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeBuiltIn_696 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax cluster asemeVarInBodyOfStatechart contains=asemePunctuation_685,asemeOperator_687,asemeName_692,asemeBuiltIn_694,asemeType_695
syntax match asemeType_695 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeBuiltIn_694 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeName_692 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_690,asemeComment_693 skipwhite skipempty
syntax region asemeComment_693 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_690,asemeComment_693 skipwhite skipempty
syntax match asemeComment_693 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_690,asemeComment_693 skipwhite skipempty
syntax match asemePunctuation_690 /\v\:/ contained nextgroup=asemeBuiltIn_688,asemeType_689,asemeComment_691 skipwhite skipempty
syntax region asemeComment_691 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_688,asemeType_689,asemeComment_691 skipwhite skipempty
syntax match asemeComment_691 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_688,asemeType_689,asemeComment_691 skipwhite skipempty
syntax match asemeType_689 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeBuiltIn_688 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeOperator_687 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_685 /\v\:/ contained nextgroup=asemeBuiltIn_682,asemeType_684,asemeComment_686 skipwhite skipempty
syntax region asemeComment_686 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_682,asemeType_684,asemeComment_686 skipwhite skipempty
syntax match asemeComment_686 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_682,asemeType_684,asemeComment_686 skipwhite skipempty
syntax match asemeType_684 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeBuiltIn_682 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax region asemeComment_683 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeComment_683 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfStatechart,asemeComment_683 skipwhite skipempty
syntax match asemeNumber_680 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_678,asemeComment_681 skipwhite skipempty
syntax region asemeComment_681 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_678,asemeComment_681 skipwhite skipempty
syntax match asemeComment_681 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_678,asemeComment_681 skipwhite skipempty
syntax match asemeOperator_678 /\v\-\>/ contained nextgroup=asemeNumber_676,asemeComment_679 skipwhite skipempty
syntax region asemeComment_679 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_676,asemeComment_679 skipwhite skipempty
syntax match asemeComment_679 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_676,asemeComment_679 skipwhite skipempty
syntax match asemeNumber_676 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_675,asemeComment_677 skipwhite skipempty
syntax region asemeComment_677 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_675,asemeComment_677 skipwhite skipempty
syntax match asemeComment_677 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_675,asemeComment_677 skipwhite skipempty
syntax match asemePunctuation_675 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeDeclaration_673 /\v%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=)@=state%(<|>)/ contained nextgroup=asemeNumber_671,asemeComment_674 skipwhite skipempty
syntax region asemeComment_674 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_671,asemeComment_674 skipwhite skipempty
syntax match asemeComment_674 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_671,asemeComment_674 skipwhite skipempty
syntax match asemeNumber_671 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_669,asemeComment_672 skipwhite skipempty
syntax region asemeComment_672 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_669,asemeComment_672 skipwhite skipempty
syntax match asemeComment_672 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_669,asemeComment_672 skipwhite skipempty
syntax match asemeChoice_669 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_667,asemeText_668,@asemeChartNodeInBodyOfStatechart,asemeComment_670 skipwhite skipempty
syntax region asemeComment_670 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_667,asemeText_668,@asemeChartNodeInBodyOfStatechart,asemeComment_670 skipwhite skipempty
syntax match asemeComment_670 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_667,asemeText_668,@asemeChartNodeInBodyOfStatechart,asemeComment_670 skipwhite skipempty
syntax match asemeText_668 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeName_667 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax cluster asemeChartNodeInBodyOfStatechart contains=asemeClause_653,asemeChoice_657,asemeNumber_663,asemeName_665,asemeText_666
syntax match asemeText_666 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeName_665 /\v%(%(state%(<|>)%(\_s*%([0-9]+%(\.[0-9]+)*%(\w)@!|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|[0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=))@!%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeNumber_663 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeChoice_661,asemeComment_664 skipwhite skipempty
syntax region asemeComment_664 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_661,asemeComment_664 skipwhite skipempty
syntax match asemeComment_664 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_661,asemeComment_664 skipwhite skipempty
syntax match asemeChoice_661 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_659,asemeText_660,@asemeChartNodeInBodyOfStatechart,asemeComment_662 skipwhite skipempty
syntax region asemeComment_662 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_659,asemeText_660,@asemeChartNodeInBodyOfStatechart,asemeComment_662 skipwhite skipempty
syntax match asemeComment_662 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_659,asemeText_660,@asemeChartNodeInBodyOfStatechart,asemeComment_662 skipwhite skipempty
syntax match asemeText_660 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeName_659 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeChoice_657 /\v%(START|END|OR|AND|BASIC|CONDITION)%(<|>)/ contained nextgroup=asemeName_655,asemeText_656,@asemeChartNodeInBodyOfStatechart,asemeComment_658 skipwhite skipempty
syntax region asemeComment_658 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_655,asemeText_656,@asemeChartNodeInBodyOfStatechart,asemeComment_658 skipwhite skipempty
syntax match asemeComment_658 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_655,asemeText_656,@asemeChartNodeInBodyOfStatechart,asemeComment_658 skipwhite skipempty
syntax match asemeText_656 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeName_655 /\v%(%(state|activity|activities|modules|var|let)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeClause_653 /\vactivity%(<|>)/ contained nextgroup=asemeReference_651,asemeComment_654 skipwhite skipempty
syntax region asemeComment_654 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_651,asemeComment_654 skipwhite skipempty
syntax match asemeComment_654 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_651,asemeComment_654 skipwhite skipempty
syntax match asemeReference_651 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax region asemeComment_652 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeComment_652 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeChartNodeInBodyOfStatechart,asemeComment_652 skipwhite skipempty
syntax match asemeDeclaration_649 /\v%(srm%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=srm%(<|>)/ nextgroup=asemeBlock_648,asemeComment_650 skipwhite skipempty
syntax region asemeComment_650 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_648,asemeComment_650 skipwhite skipempty
syntax match asemeComment_650 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_648,asemeComment_650 skipwhite skipempty
syntax match asemeBlock_648 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_406 skipwhite skipempty
syntax match asemeDeclaration_646 /\v%(abstract%(<|>)%(\_s*%(srm%(<|>)|%($|\/\/|\/\*)))@=)@=abstract%(<|>)/ nextgroup=asemeClause_644,asemeComment_647 skipwhite skipempty
syntax region asemeComment_647 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_644,asemeComment_647 skipwhite skipempty
syntax match asemeComment_647 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_644,asemeComment_647 skipwhite skipempty
syntax match asemeClause_644 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_643,asemeComment_645 skipwhite skipempty
syntax region asemeComment_645 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_643,asemeComment_645 skipwhite skipempty
syntax match asemeComment_645 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_643,asemeComment_645 skipwhite skipempty
syntax match asemeBlock_643 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_406 skipwhite skipempty
syntax cluster asemeSrmInFile contains=asemeClause_407,asemePunctuation_641,asemeBlock_642
syntax match asemeBlock_642 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_406 skipwhite skipempty
syntax region asemePunctuation_641 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfSrm
syntax cluster asemeBodyOfSrm contains=asemeDeclaration_415,asemeDeclaration_451,asemeDeclaration_467,asemeDeclaration_489,asemeDeclaration_494,asemeDeclaration_518,asemeDeclaration_575,asemeDeclaration_620,asemeDeclaration_629,asemeDeclaration_639,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_639 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_637,asemeComment_640 skipwhite skipempty
syntax region asemeComment_640 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_637,asemeComment_640 skipwhite skipempty
syntax match asemeComment_640 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_637,asemeComment_640 skipwhite skipempty
syntax match asemeBlock_637 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_636,@asemeControlInBodyOfSrm,asemeComment_638 skipwhite skipempty
syntax region asemeComment_638 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_636,@asemeControlInBodyOfSrm,asemeComment_638 skipwhite skipempty
syntax match asemeComment_638 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_636,@asemeControlInBodyOfSrm,asemeComment_638 skipwhite skipempty
syntax match asemeOperator_636 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_632 skipwhite skipempty
syntax cluster asemeControlInBodyOfSrm contains=asemePunctuation_388,asemeOperator_631,asemeBlock_634
syntax match asemeBlock_634 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_633,@asemeControlInBodyOfSrm,asemeComment_635 skipwhite skipempty
syntax region asemeComment_635 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_633,@asemeControlInBodyOfSrm,asemeComment_635 skipwhite skipempty
syntax match asemeComment_635 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_633,@asemeControlInBodyOfSrm,asemeComment_635 skipwhite skipempty
syntax match asemeOperator_633 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_632 skipwhite skipempty
syntax match asemeOperator_631 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfSrm,asemeComment_632 skipwhite skipempty
syntax region asemeComment_632 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_632 skipwhite skipempty
syntax match asemeComment_632 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfSrm,asemeComment_632 skipwhite skipempty
syntax match asemeDeclaration_629 /\v%(functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=functionality%(<|>)/ contained nextgroup=asemeBlock_628,asemeComment_630 skipwhite skipempty
syntax region asemeComment_630 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_628,asemeComment_630 skipwhite skipempty
syntax match asemeComment_630 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_628,asemeComment_630 skipwhite skipempty
syntax match asemeBlock_628 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_627 skipwhite skipempty
syntax cluster asemeFunctionalityInBodyOfSrm contains=asemePunctuation_625,asemeBlock_626
syntax match asemeBlock_626 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_627 skipwhite skipempty
syntax region asemeComment_627 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_627 skipwhite skipempty
syntax match asemeComment_627 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFunctionalityInBodyOfSrm,asemeComment_627 skipwhite skipempty
syntax region asemePunctuation_625 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfFunctionality
syntax cluster asemeBodyOfFunctionality contains=asemeDeclaration_623,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_623 /\v%(%(technology|permissions|environment|algorithm)%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=%(technology|permissions|environment|algorithm)%(<|>)/ contained nextgroup=asemeText_622,asemeComment_624 skipwhite skipempty
syntax region asemeComment_624 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_622,asemeComment_624 skipwhite skipempty
syntax match asemeComment_624 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_622,asemeComment_624 skipwhite skipempty
syntax match asemeText_622 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_620 /\v%(modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=modules%(<|>)/ contained nextgroup=@asemeModulesInBodyOfSrm,asemeComment_621 skipwhite skipempty
syntax region asemeComment_621 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_621 skipwhite skipempty
syntax match asemeComment_621 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModulesInBodyOfSrm,asemeComment_621 skipwhite skipempty
syntax cluster asemeModulesInBodyOfSrm contains=asemePunctuation_619
syntax region asemePunctuation_619 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfModules
syntax cluster asemeBodyOfModules contains=asemeName_618,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_618 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax cluster asemeModuleInBodyOfModules contains=asemeClause_582,asemeClause_585,asemeClause_588,asemeClause_591,asemeClause_594,asemeClause_597,asemeClause_600,asemeClause_603,asemeClause_606,asemePunctuation_613,asemeOperator_616
syntax match asemeOperator_616 /\v\=%(\=)@!/ contained nextgroup=asemeText_615,asemeComment_617 skipwhite skipempty
syntax region asemeComment_617 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_615,asemeComment_617 skipwhite skipempty
syntax match asemeComment_617 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_615,asemeComment_617 skipwhite skipempty
syntax match asemeText_615 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemePunctuation_613 /\v\,/ contained nextgroup=asemeChoice_609,asemeReference_611,asemeReference_612,asemeComment_614 skipwhite skipempty
syntax region asemeComment_614 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_609,asemeReference_611,asemeReference_612,asemeComment_614 skipwhite skipempty
syntax match asemeComment_614 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_609,asemeReference_611,asemeReference_612,asemeComment_614 skipwhite skipempty
syntax match asemeReference_612 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeReference_611 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeChoice_609 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_608,asemeComment_610 skipwhite skipempty
syntax region asemeComment_610 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_608,asemeComment_610 skipwhite skipempty
syntax match asemeComment_610 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_608,asemeComment_610 skipwhite skipempty
syntax match asemeReference_608 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_606 /\vends%(<|>)/ contained nextgroup=asemeReference_605,asemeComment_607 skipwhite skipempty
syntax region asemeComment_607 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_605,asemeComment_607 skipwhite skipempty
syntax match asemeComment_607 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_605,asemeComment_607 skipwhite skipempty
syntax match asemeReference_605 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_603 /\vwrites%(<|>)/ contained nextgroup=asemeReference_602,asemeComment_604 skipwhite skipempty
syntax region asemeComment_604 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_602,asemeComment_604 skipwhite skipempty
syntax match asemeComment_604 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_602,asemeComment_604 skipwhite skipempty
syntax match asemeReference_602 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_600 /\vfor%(<|>)/ contained nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax region asemeComment_601 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax match asemeComment_601 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_599,asemeComment_601 skipwhite skipempty
syntax match asemeNumber_599 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_597 /\vuses%(<|>)/ contained nextgroup=asemeReference_596,asemeComment_598 skipwhite skipempty
syntax region asemeComment_598 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_596,asemeComment_598 skipwhite skipempty
syntax match asemeComment_598 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_596,asemeComment_598 skipwhite skipempty
syntax match asemeReference_596 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_594 /\vas%(<|>)/ contained nextgroup=asemeChoice_593,asemeComment_595 skipwhite skipempty
syntax region asemeComment_595 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_593,asemeComment_595 skipwhite skipempty
syntax match asemeComment_595 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_593,asemeComment_595 skipwhite skipempty
syntax match asemeChoice_593 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_591 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_590,asemeComment_592 skipwhite skipempty
syntax region asemeComment_592 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_590,asemeComment_592 skipwhite skipempty
syntax match asemeComment_592 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_590,asemeComment_592 skipwhite skipempty
syntax match asemeNumber_590 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_588 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_587,asemeComment_589 skipwhite skipempty
syntax region asemeComment_589 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_587,asemeComment_589 skipwhite skipempty
syntax match asemeComment_589 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_587,asemeComment_589 skipwhite skipempty
syntax match asemeNumber_587 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_585 /\vevery%(<|>)/ contained nextgroup=asemeNumber_584,asemeComment_586 skipwhite skipempty
syntax region asemeComment_586 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_584,asemeComment_586 skipwhite skipempty
syntax match asemeComment_586 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_584,asemeComment_586 skipwhite skipempty
syntax match asemeNumber_584 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeClause_582 /\vreads%(<|>)/ contained nextgroup=asemeChoice_579,asemeReference_581,asemeComment_583 skipwhite skipempty
syntax region asemeComment_583 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_579,asemeReference_581,asemeComment_583 skipwhite skipempty
syntax match asemeComment_583 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_579,asemeReference_581,asemeComment_583 skipwhite skipempty
syntax match asemeReference_581 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeChoice_579 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_577,asemeComment_580 skipwhite skipempty
syntax region asemeComment_580 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_577,asemeComment_580 skipwhite skipempty
syntax match asemeComment_580 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_577,asemeComment_580 skipwhite skipempty
syntax match asemeReference_577 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax region asemeComment_578 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeComment_578 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeModuleInBodyOfModules,asemeComment_578 skipwhite skipempty
syntax match asemeDeclaration_575 /\v%(activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=activities%(<|>)/ contained nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_576 skipwhite skipempty
syntax region asemeComment_576 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_576 skipwhite skipempty
syntax match asemeComment_576 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivitiesInBodyOfSrm,asemeComment_576 skipwhite skipempty
syntax cluster asemeActivitiesInBodyOfSrm contains=asemePunctuation_574
syntax region asemePunctuation_574 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfActivities
syntax cluster asemeBodyOfActivities contains=asemeName_573,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_573 /\v%(%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=%(%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax cluster asemeActivityInBodyOfActivities contains=asemeClause_525,asemeClause_528,asemeClause_531,asemeClause_534,asemeClause_537,asemeClause_540,asemeClause_543,asemeClause_546,asemeClause_549,asemePunctuation_557,asemePunctuation_570,asemePunctuation_572
syntax match asemePunctuation_572 /\v\)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemePunctuation_570 /\v\,/ contained nextgroup=asemeName_563,asemeChoice_566,asemeReference_568,asemeReference_569,asemeComment_571 skipwhite skipempty
syntax region asemeComment_571 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_563,asemeChoice_566,asemeReference_568,asemeReference_569,asemeComment_571 skipwhite skipempty
syntax match asemeComment_571 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_563,asemeChoice_566,asemeReference_568,asemeReference_569,asemeComment_571 skipwhite skipempty
syntax match asemeReference_569 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeReference_568 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeChoice_566 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax region asemeComment_567 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax match asemeComment_567 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_565,asemeComment_567 skipwhite skipempty
syntax match asemeReference_565 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeName_563 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_561,asemeComment_564 skipwhite skipempty
syntax region asemeComment_564 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_561,asemeComment_564 skipwhite skipempty
syntax match asemeComment_564 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_561,asemeComment_564 skipwhite skipempty
syntax match asemePunctuation_561 /\v\:/ contained nextgroup=asemeBuiltIn_559,asemeType_560,asemeComment_562 skipwhite skipempty
syntax region asemeComment_562 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_559,asemeType_560,asemeComment_562 skipwhite skipempty
syntax match asemeComment_562 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_559,asemeType_560,asemeComment_562 skipwhite skipempty
syntax match asemeType_560 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeBuiltIn_559 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemePunctuation_557 /\v\(/ contained nextgroup=asemeName_555,asemeComment_558 skipwhite skipempty
syntax region asemeComment_558 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_555,asemeComment_558 skipwhite skipempty
syntax match asemeComment_558 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_555,asemeComment_558 skipwhite skipempty
syntax match asemeName_555 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_553,asemeComment_556 skipwhite skipempty
syntax region asemeComment_556 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_553,asemeComment_556 skipwhite skipempty
syntax match asemeComment_556 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_553,asemeComment_556 skipwhite skipempty
syntax match asemePunctuation_553 /\v\:/ contained nextgroup=asemeBuiltIn_551,asemeType_552,asemeComment_554 skipwhite skipempty
syntax region asemeComment_554 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_551,asemeType_552,asemeComment_554 skipwhite skipempty
syntax match asemeComment_554 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_551,asemeType_552,asemeComment_554 skipwhite skipempty
syntax match asemeType_552 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeBuiltIn_551 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_549 /\vends%(<|>)/ contained nextgroup=asemeReference_548,asemeComment_550 skipwhite skipempty
syntax region asemeComment_550 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_548,asemeComment_550 skipwhite skipempty
syntax match asemeComment_550 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_548,asemeComment_550 skipwhite skipempty
syntax match asemeReference_548 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_546 /\vwrites%(<|>)/ contained nextgroup=asemeReference_545,asemeComment_547 skipwhite skipempty
syntax region asemeComment_547 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_545,asemeComment_547 skipwhite skipempty
syntax match asemeComment_547 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_545,asemeComment_547 skipwhite skipempty
syntax match asemeReference_545 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_543 /\vfor%(<|>)/ contained nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax region asemeComment_544 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax match asemeComment_544 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_542,asemeComment_544 skipwhite skipempty
syntax match asemeNumber_542 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_540 /\vuses%(<|>)/ contained nextgroup=asemeReference_539,asemeComment_541 skipwhite skipempty
syntax region asemeComment_541 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_539,asemeComment_541 skipwhite skipempty
syntax match asemeComment_541 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_539,asemeComment_541 skipwhite skipempty
syntax match asemeReference_539 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_537 /\vas%(<|>)/ contained nextgroup=asemeChoice_536,asemeComment_538 skipwhite skipempty
syntax region asemeComment_538 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_536,asemeComment_538 skipwhite skipempty
syntax match asemeComment_538 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_536,asemeComment_538 skipwhite skipempty
syntax match asemeChoice_536 /\v%(thread|async|process|step)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_534 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_533,asemeComment_535 skipwhite skipempty
syntax region asemeComment_535 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_533,asemeComment_535 skipwhite skipempty
syntax match asemeComment_535 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_533,asemeComment_535 skipwhite skipempty
syntax match asemeNumber_533 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_531 /\vtakes%(<|>)/ contained nextgroup=asemeNumber_530,asemeComment_532 skipwhite skipempty
syntax region asemeComment_532 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_530,asemeComment_532 skipwhite skipempty
syntax match asemeComment_532 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_530,asemeComment_532 skipwhite skipempty
syntax match asemeNumber_530 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_528 /\vevery%(<|>)/ contained nextgroup=asemeNumber_527,asemeComment_529 skipwhite skipempty
syntax region asemeComment_529 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_527,asemeComment_529 skipwhite skipempty
syntax match asemeComment_529 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_527,asemeComment_529 skipwhite skipempty
syntax match asemeNumber_527 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeClause_525 /\vreads%(<|>)/ contained nextgroup=asemeChoice_522,asemeReference_524,asemeComment_526 skipwhite skipempty
syntax region asemeComment_526 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_522,asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeComment_526 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_522,asemeReference_524,asemeComment_526 skipwhite skipempty
syntax match asemeReference_524 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeChoice_522 /\v%(above|below|around)%(<|>)%(\_s*[.,])@!/ contained nextgroup=asemeReference_520,asemeComment_523 skipwhite skipempty
syntax region asemeComment_523 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_520,asemeComment_523 skipwhite skipempty
syntax match asemeComment_523 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_520,asemeComment_523 skipwhite skipempty
syntax match asemeReference_520 /\v%([A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*[A-Za-z_][A-Za-z0-9_]*%(<|>)|\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s+%(every|takes|within|as|uses|reads|writes|ends)%(<|>))@!))*%(<|>))/ contained nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax region asemeComment_521 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeComment_521 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeActivityInBodyOfActivities,asemeComment_521 skipwhite skipempty
syntax match asemeDeclaration_518 /\v%(liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=)@=liveness%(<|>)/ contained nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_519 skipwhite skipempty
syntax region asemeComment_519 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_519 skipwhite skipempty
syntax match asemeComment_519 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLivenessInBodyOfSrm,asemeComment_519 skipwhite skipempty
syntax cluster asemeLivenessInBodyOfSrm contains=asemePunctuation_517
syntax region asemePunctuation_517 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfLiveness
syntax cluster asemeBodyOfLiveness contains=asemeName_516,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_516 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax cluster asemeFormulaInBodyOfLiveness contains=asemePunctuation_498,asemePunctuation_502,asemePunctuation_505,asemePunctuation_507,asemeOperator_515
syntax match asemeOperator_515 /\v\=%(\=)@!/ contained nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax cluster asemeFormulaToken contains=asemeText_508,asemeNumber_510,asemeReference_511,asemeNumber_512,asemeOperator_513,asemePunctuation_514
syntax match asemePunctuation_514 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemeOperator_513 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemeNumber_512 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemeReference_511 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemeNumber_510 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemeText_508 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax region asemeComment_509 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemeComment_509 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaToken,asemeComment_509 skipwhite skipempty
syntax match asemePunctuation_507 /\v\)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax match asemePunctuation_505 /\v\,/ contained nextgroup=asemeName_504,asemeComment_506 skipwhite skipempty
syntax region asemeComment_506 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_504,asemeComment_506 skipwhite skipempty
syntax match asemeComment_506 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_504,asemeComment_506 skipwhite skipempty
syntax match asemeName_504 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax match asemePunctuation_502 /\v\:/ contained nextgroup=asemeBuiltIn_500,asemeType_501,asemeComment_503 skipwhite skipempty
syntax region asemeComment_503 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_500,asemeType_501,asemeComment_503 skipwhite skipempty
syntax match asemeComment_503 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_500,asemeType_501,asemeComment_503 skipwhite skipempty
syntax match asemeType_501 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax match asemeBuiltIn_500 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax match asemePunctuation_498 /\v\(/ contained nextgroup=asemeName_496,asemeComment_499 skipwhite skipempty
syntax region asemeComment_499 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_496,asemeComment_499 skipwhite skipempty
syntax match asemeComment_499 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_496,asemeComment_499 skipwhite skipempty
syntax match asemeName_496 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax region asemeComment_497 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax match asemeComment_497 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeFormulaInBodyOfLiveness,asemeComment_497 skipwhite skipempty
syntax match asemeDeclaration_494 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_492,asemeComment_495 skipwhite skipempty
syntax region asemeComment_495 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_492,asemeComment_495 skipwhite skipempty
syntax match asemeComment_495 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_492,asemeComment_495 skipwhite skipempty
syntax match asemeName_492 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_491,asemeComment_493 skipwhite skipempty
syntax region asemeComment_493 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_491,asemeComment_493 skipwhite skipempty
syntax match asemeComment_493 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_491,asemeComment_493 skipwhite skipempty
syntax match asemeOperator_491 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_489 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_487,asemeComment_490 skipwhite skipempty
syntax region asemeComment_490 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_487,asemeComment_490 skipwhite skipempty
syntax match asemeComment_490 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_487,asemeComment_490 skipwhite skipempty
syntax match asemeName_487 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_485,asemeComment_488 skipwhite skipempty
syntax region asemeComment_488 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_485,asemeComment_488 skipwhite skipempty
syntax match asemeComment_488 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_485,asemeComment_488 skipwhite skipempty
syntax match asemePunctuation_485 /\v\:/ contained nextgroup=asemeBuiltIn_483,asemeType_484,asemeComment_486 skipwhite skipempty
syntax region asemeComment_486 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_483,asemeType_484,asemeComment_486 skipwhite skipempty
syntax match asemeComment_486 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_483,asemeType_484,asemeComment_486 skipwhite skipempty
syntax match asemeType_484 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeBuiltIn_483 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax cluster asemeVarInBodyOfSrm contains=asemePunctuation_472,asemeOperator_474,asemeName_479,asemeBuiltIn_481,asemeType_482
syntax match asemeType_482 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeBuiltIn_481 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeName_479 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_477,asemeComment_480 skipwhite skipempty
syntax region asemeComment_480 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_477,asemeComment_480 skipwhite skipempty
syntax match asemeComment_480 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_477,asemeComment_480 skipwhite skipempty
syntax match asemePunctuation_477 /\v\:/ contained nextgroup=asemeBuiltIn_475,asemeType_476,asemeComment_478 skipwhite skipempty
syntax region asemeComment_478 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_475,asemeType_476,asemeComment_478 skipwhite skipempty
syntax match asemeComment_478 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_475,asemeType_476,asemeComment_478 skipwhite skipempty
syntax match asemeType_476 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeBuiltIn_475 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeOperator_474 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemePunctuation_472 /\v\:/ contained nextgroup=asemeBuiltIn_469,asemeType_471,asemeComment_473 skipwhite skipempty
syntax region asemeComment_473 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_469,asemeType_471,asemeComment_473 skipwhite skipempty
syntax match asemeComment_473 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_469,asemeType_471,asemeComment_473 skipwhite skipempty
syntax match asemeType_471 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeBuiltIn_469 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax region asemeComment_470 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeComment_470 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeVarInBodyOfSrm,asemeComment_470 skipwhite skipempty
syntax match asemeDeclaration_467 /\v%(capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=capability%(<|>)/ contained nextgroup=asemeName_465,asemeComment_468 skipwhite skipempty
syntax region asemeComment_468 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_465,asemeComment_468 skipwhite skipempty
syntax match asemeComment_468 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_465,asemeComment_468 skipwhite skipempty
syntax match asemeName_465 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_464,@asemeCapabilityInBodyOfSrm,asemeComment_466 skipwhite skipempty
syntax region asemeComment_466 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_464,@asemeCapabilityInBodyOfSrm,asemeComment_466 skipwhite skipempty
syntax match asemeComment_466 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_464,@asemeCapabilityInBodyOfSrm,asemeComment_466 skipwhite skipempty
syntax match asemeText_464 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax cluster asemeCapabilityInBodyOfSrm contains=asemeOperator_455,asemePunctuation_458,asemeText_460,asemeName_462
syntax match asemeName_462 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeText_461,@asemeCapabilityInBodyOfSrm,asemeComment_463 skipwhite skipempty
syntax region asemeComment_463 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_461,@asemeCapabilityInBodyOfSrm,asemeComment_463 skipwhite skipempty
syntax match asemeComment_463 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_461,@asemeCapabilityInBodyOfSrm,asemeComment_463 skipwhite skipempty
syntax match asemeText_461 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeText_460 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemePunctuation_458 /\v\,/ contained nextgroup=asemeReference_457,asemeComment_459 skipwhite skipempty
syntax region asemeComment_459 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_457,asemeComment_459 skipwhite skipempty
syntax match asemeComment_459 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_457,asemeComment_459 skipwhite skipempty
syntax match asemeReference_457 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeOperator_455 /\v\=%(\=)@!/ contained nextgroup=asemeReference_453,asemeComment_456 skipwhite skipempty
syntax region asemeComment_456 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_453,asemeComment_456 skipwhite skipempty
syntax match asemeComment_456 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_453,asemeComment_456 skipwhite skipempty
syntax match asemeReference_453 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax region asemeComment_454 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeComment_454 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeCapabilityInBodyOfSrm,asemeComment_454 skipwhite skipempty
syntax match asemeDeclaration_451 /\v%(plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=plays%(<|>)/ contained nextgroup=asemeReference_449,asemeComment_452 skipwhite skipempty
syntax region asemeComment_452 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_449,asemeComment_452 skipwhite skipempty
syntax match asemeComment_452 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_449,asemeComment_452 skipwhite skipempty
syntax match asemeReference_449 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\.)@=/ contained nextgroup=asemePunctuation_447,asemeComment_450 skipwhite skipempty
syntax region asemeComment_450 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_447,asemeComment_450 skipwhite skipempty
syntax match asemeComment_450 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_447,asemeComment_450 skipwhite skipempty
syntax match asemePunctuation_447 /\v\./ contained nextgroup=asemeReference_446,asemeComment_448 skipwhite skipempty
syntax region asemeComment_448 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_446,asemeComment_448 skipwhite skipempty
syntax match asemeComment_448 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_446,asemeComment_448 skipwhite skipempty
syntax match asemeReference_446 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax cluster asemePlaysInBodyOfSrm contains=asemeClause_423,asemeClause_426,asemePunctuation_436,asemePunctuation_439,asemeReference_444
syntax match asemeReference_444 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemePunctuation_442,@asemePlaysInBodyOfSrm,asemeComment_445 skipwhite skipempty
syntax region asemeComment_445 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_442,@asemePlaysInBodyOfSrm,asemeComment_445 skipwhite skipempty
syntax match asemeComment_445 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_442,@asemePlaysInBodyOfSrm,asemeComment_445 skipwhite skipempty
syntax match asemePunctuation_442 /\v\./ contained nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax region asemeComment_443 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax match asemeComment_443 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_441,asemeComment_443 skipwhite skipempty
syntax match asemeReference_441 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemePunctuation_439 /\v\./ contained nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax region asemeComment_440 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax match asemeComment_440 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_438,asemeComment_440 skipwhite skipempty
syntax match asemeReference_438 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemePunctuation_436 /\v\,/ contained nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax region asemeComment_437 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax match asemeComment_437 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_434,asemeComment_437 skipwhite skipempty
syntax match asemeReference_434 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\=%(\=)@!|\.))@=/ contained nextgroup=asemeOperator_429,asemePunctuation_432,asemeComment_435 skipwhite skipempty
syntax region asemeComment_435 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_429,asemePunctuation_432,asemeComment_435 skipwhite skipempty
syntax match asemeComment_435 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_429,asemePunctuation_432,asemeComment_435 skipwhite skipempty
syntax match asemePunctuation_432 /\v\./ contained nextgroup=asemeReference_431,asemeComment_433 skipwhite skipempty
syntax region asemeComment_433 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_431,asemeComment_433 skipwhite skipempty
syntax match asemeComment_433 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_431,asemeComment_433 skipwhite skipempty
syntax match asemeReference_431 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemeOperator_429 /\v\=%(\=)@!/ contained nextgroup=asemeReference_428,asemeComment_430 skipwhite skipempty
syntax region asemeComment_430 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_428,asemeComment_430 skipwhite skipempty
syntax match asemeComment_430 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_428,asemeComment_430 skipwhite skipempty
syntax match asemeReference_428 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemeClause_426 /\vas%(<|>)/ contained nextgroup=asemeReference_425,asemeComment_427 skipwhite skipempty
syntax region asemeComment_427 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_425,asemeComment_427 skipwhite skipempty
syntax match asemeComment_427 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_425,asemeComment_427 skipwhite skipempty
syntax match asemeReference_425 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemeClause_423 /\vwith%(<|>)/ contained nextgroup=asemeReference_421,asemeComment_424 skipwhite skipempty
syntax region asemeComment_424 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_421,asemeComment_424 skipwhite skipempty
syntax match asemeComment_424 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_421,asemeComment_424 skipwhite skipempty
syntax match asemeReference_421 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_419,asemeComment_422 skipwhite skipempty
syntax region asemeComment_422 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_419,asemeComment_422 skipwhite skipempty
syntax match asemeComment_422 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_419,asemeComment_422 skipwhite skipempty
syntax match asemeOperator_419 /\v\=%(\=)@!/ contained nextgroup=asemeReference_417,asemeComment_420 skipwhite skipempty
syntax region asemeComment_420 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_417,asemeComment_420 skipwhite skipempty
syntax match asemeComment_420 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_417,asemeComment_420 skipwhite skipempty
syntax match asemeReference_417 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax region asemeComment_418 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemeComment_418 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemePlaysInBodyOfSrm,asemeComment_418 skipwhite skipempty
syntax match asemeDeclaration_415 /\v%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=includes%(<|>)/ contained nextgroup=asemeReference_414,asemeComment_416 skipwhite skipempty
syntax region asemeComment_416 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_414,asemeComment_416 skipwhite skipempty
syntax match asemeComment_416 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_414,asemeComment_416 skipwhite skipempty
syntax match asemeReference_414 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_410 skipwhite skipempty
syntax cluster asemeInclusionInBodyOfSrm contains=asemePunctuation_411,asemeReference_413
syntax match asemeReference_413 /\v%(%(includes%(<|>)%(\_s*%(%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|plays%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|capability%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|liveness%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|activities%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|modules%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|functionality%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@!%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_410 skipwhite skipempty
syntax match asemePunctuation_411 /\v\,/ contained nextgroup=asemeReference_409,asemeComment_412 skipwhite skipempty
syntax region asemeComment_412 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_409,asemeComment_412 skipwhite skipempty
syntax match asemeComment_412 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_409,asemeComment_412 skipwhite skipempty
syntax match asemeReference_409 /\v%(%(%(liveness|activities|modules)\_s*\{|%(includes|plays|capability|var|let|functionality|control)\_s+\w))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_410 skipwhite skipempty
syntax region asemeComment_410 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_410 skipwhite skipempty
syntax match asemeComment_410 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeInclusionInBodyOfSrm,asemeComment_410 skipwhite skipempty
syntax match asemeClause_407 /\vsrm%(<|>)/ contained nextgroup=asemeBlock_405,asemeComment_408 skipwhite skipempty
syntax region asemeComment_408 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_405,asemeComment_408 skipwhite skipempty
syntax match asemeComment_408 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_405,asemeComment_408 skipwhite skipempty
syntax match asemeBlock_405 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeSrmInFile,asemeComment_406 skipwhite skipempty
syntax region asemeComment_406 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_406 skipwhite skipempty
syntax match asemeComment_406 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSrmInFile,asemeComment_406 skipwhite skipempty
syntax match asemeDeclaration_403 /\v%(aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=aip%(<|>)/ nextgroup=asemeBlock_402,asemeComment_404 skipwhite skipempty
syntax region asemeComment_404 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_402,asemeComment_404 skipwhite skipempty
syntax match asemeComment_404 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_402,asemeComment_404 skipwhite skipempty
syntax match asemeBlock_402 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_401 skipwhite skipempty
syntax cluster asemeAipInFile contains=asemePunctuation_399,asemeBlock_400
syntax match asemeBlock_400 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeAipInFile,asemeComment_401 skipwhite skipempty
syntax region asemeComment_401 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_401 skipwhite skipempty
syntax match asemeComment_401 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeAipInFile,asemeComment_401 skipwhite skipempty
syntax region asemePunctuation_399 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfAip
syntax cluster asemeBodyOfAip contains=asemeDeclaration_295,asemeDeclaration_298,asemeDeclaration_326,asemeDeclaration_330,asemeDeclaration_397,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeDeclaration_397 /\v%(control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=control%(<|>)/ contained nextgroup=asemeBlock_395,asemeComment_398 skipwhite skipempty
syntax region asemeComment_398 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_395,asemeComment_398 skipwhite skipempty
syntax match asemeComment_398 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_395,asemeComment_398 skipwhite skipempty
syntax match asemeBlock_395 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_394,@asemeControlInBodyOfAip,asemeComment_396 skipwhite skipempty
syntax region asemeComment_396 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_394,@asemeControlInBodyOfAip,asemeComment_396 skipwhite skipempty
syntax match asemeComment_396 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_394,@asemeControlInBodyOfAip,asemeComment_396 skipwhite skipempty
syntax match asemeOperator_394 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_390 skipwhite skipempty
syntax cluster asemeControlInBodyOfAip contains=asemePunctuation_388,asemeOperator_389,asemeBlock_392
syntax match asemeBlock_392 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=asemeOperator_391,@asemeControlInBodyOfAip,asemeComment_393 skipwhite skipempty
syntax region asemeComment_393 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_391,@asemeControlInBodyOfAip,asemeComment_393 skipwhite skipempty
syntax match asemeComment_393 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_391,@asemeControlInBodyOfAip,asemeComment_393 skipwhite skipempty
syntax match asemeOperator_391 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_390 skipwhite skipempty
syntax match asemeOperator_389 /\vreactive%(<|>)/ contained nextgroup=@asemeControlInBodyOfAip,asemeComment_390 skipwhite skipempty
syntax region asemeComment_390 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_390 skipwhite skipempty
syntax match asemeComment_390 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlInBodyOfAip,asemeComment_390 skipwhite skipempty
syntax region asemePunctuation_388 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfControl
syntax cluster asemeBodyOfControl contains=asemeDeclaration_363,asemeNumber_386,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeNumber_386 /\v%([0-9]+%(\.[0-9]+)*%(\w)@!%(\_s*\-\>)@=)@=[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemeOperator_384,asemeComment_387 skipwhite skipempty
syntax region asemeComment_387 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_384,asemeComment_387 skipwhite skipempty
syntax match asemeComment_387 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_384,asemeComment_387 skipwhite skipempty
syntax match asemeOperator_384 /\v\-\>/ contained nextgroup=asemeNumber_382,asemeComment_385 skipwhite skipempty
syntax region asemeComment_385 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_382,asemeComment_385 skipwhite skipempty
syntax match asemeComment_385 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_382,asemeComment_385 skipwhite skipempty
syntax match asemeNumber_382 /\v[0-9]+%(\.[0-9]+)*%(\w)@!/ contained nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax region asemeComment_383 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax match asemeComment_383 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_381,asemeComment_383 skipwhite skipempty
syntax match asemePunctuation_381 /\v\:/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax cluster asemeLabelledWay contains=asemeText_364,asemeNumber_366,asemeTruth_367,asemeLogic_368,asemeClause_369,asemeClause_370,asemeClause_371,asemeClause_372,asemeClause_373,asemeClause_374,asemeClause_375,asemeClause_376,asemeCall_377,asemeReference_378,asemeOperator_379,asemePunctuation_380
syntax match asemePunctuation_380 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeOperator_379 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeReference_378 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeCall_377 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_376 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_375 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_374 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_373 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_372 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_371 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_370 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeClause_369 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeLogic_368 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeTruth_367 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeNumber_366 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeText_364 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax region asemeComment_365 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeComment_365 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeLabelledWay,asemeComment_365 skipwhite skipempty
syntax match asemeDeclaration_363 /\v%(%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)%(\_s*%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,]))|%($|\/\/|\/\*)))@=)@=%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax cluster asemeWayInBodyOfControl contains=asemeClause_334,asemeOperator_337,asemePunctuation_356,asemeText_357,asemeNumber_358,asemeReference_359,asemeNumber_360,asemeOperator_361,asemePunctuation_362
syntax match asemePunctuation_362 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeOperator_361 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeNumber_360 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]\w*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeReference_359 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeNumber_358 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeText_357 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\?\w*\?|%(%(every\_s+[0-9]|%(enter|skip|repeat|leave|start|finish|else|when|and|or|not)%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>)|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|\-%(\>)@!|[.|()\[\]~*+&;,])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemePunctuation_356 /\v\:/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax cluster asemeControlToken contains=asemeText_339,asemeNumber_341,asemeTruth_342,asemeLogic_343,asemeClause_344,asemeClause_345,asemeClause_346,asemeClause_347,asemeClause_348,asemeClause_349,asemeClause_350,asemeClause_351,asemeCall_352,asemeReference_353,asemeOperator_354,asemePunctuation_355
syntax match asemePunctuation_355 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeOperator_354 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeReference_353 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeCall_352 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_351 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_350 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_349 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_348 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_347 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_346 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_345 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=when%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeClause_344 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=else%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeLogic_343 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeTruth_342 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeNumber_341 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeText_339 /\v%(%(%(%(%(enter|skip|repeat|leave|start|finish)%(<|>)%(\_s*\.)@!|%(on|exit|resume)\_s+%(%(%(<|>)%(enter|skip|repeat|leave|start|finish|on|exit|resume)%(<|>))@![0-9A-Za-z_ \t.|()\[\]~*+#>])+\:|[0-9]+%(\.[0-9]+)*\_s*\-\>|state\_s+[0-9]|%(outcome\_s*\"|clause\_s+\w|let\_s+\w+\_s*\=%(\=)@!|var\_s+\w+\_s*\:|plays\_s+\w+\_s*\.)))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|%(send\_s+[A-Za-z_]\w*\_s+[A-Za-z_]\w*|write_messages%(\_s*\.\_s*[A-Za-z_]\w*)+)\_s*\{%(\"%([^"\\\n]|\\.)*\"|%(to%(<|>)%(\_s*[=.])@!)@![A-Za-z_]\w*|[^{}":A-Za-z_])*\}|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.%([ \t]*|\_s+%(%(enter|skip|repeat|leave|start|finish)%(<|>))@!)[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax region asemeComment_340 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeComment_340 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeControlToken,asemeComment_340 skipwhite skipempty
syntax match asemeOperator_337 /\v\#/ contained nextgroup=asemeNumber_336,asemeComment_338 skipwhite skipempty
syntax region asemeComment_338 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_336,asemeComment_338 skipwhite skipempty
syntax match asemeComment_338 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_336,asemeComment_338 skipwhite skipempty
syntax match asemeNumber_336 /\v[0-9]+%(%(\w|\.[0-9]))@!/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeClause_334 /\vevery%(<|>)/ contained nextgroup=asemeNumber_332,asemeComment_335 skipwhite skipempty
syntax region asemeComment_335 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_332,asemeComment_335 skipwhite skipempty
syntax match asemeComment_335 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_332,asemeComment_335 skipwhite skipempty
syntax match asemeNumber_332 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax region asemeComment_333 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeComment_333 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeWayInBodyOfControl,asemeComment_333 skipwhite skipempty
syntax match asemeDeclaration_330 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_328,asemeComment_331 skipwhite skipempty
syntax region asemeComment_331 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_328,asemeComment_331 skipwhite skipempty
syntax match asemeComment_331 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_328,asemeComment_331 skipwhite skipempty
syntax match asemeName_328 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_327,asemeComment_329 skipwhite skipempty
syntax region asemeComment_329 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_327,asemeComment_329 skipwhite skipempty
syntax match asemeComment_329 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_327,asemeComment_329 skipwhite skipempty
syntax match asemeOperator_327 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_326 /\v%(clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=clause%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax cluster asemeClauseInBodyOfAip contains=asemeClause_305,asemeClause_308,asemeClause_311,asemeClause_314,asemeClause_316,asemeClause_317,asemePunctuation_319,asemeOperator_322,asemePunctuation_324,asemeName_325
syntax match asemeName_325 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemePunctuation_324 /\v\)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeOperator_322 /\v\@/ contained nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax region asemeComment_323 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax match asemeComment_323 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_321,asemeComment_323 skipwhite skipempty
syntax match asemeReference_321 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemePunctuation_319 /\v\(/ contained nextgroup=asemeName_318,asemeComment_320 skipwhite skipempty
syntax region asemeComment_320 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_318,asemeComment_320 skipwhite skipempty
syntax match asemeComment_320 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_318,asemeComment_320 skipwhite skipempty
syntax match asemeName_318 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeClause_317 /\vbefore%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeClause_316 /\vevery%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeClause_314 /\vwithin%(<|>)/ contained nextgroup=asemeNumber_313,asemeComment_315 skipwhite skipempty
syntax region asemeComment_315 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeNumber_313,asemeComment_315 skipwhite skipempty
syntax match asemeComment_315 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeNumber_313,asemeComment_315 skipwhite skipempty
syntax match asemeNumber_313 /\v[0-9]+%(\.[0-9]+)?%(ms|s|min)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeClause_311 /\vleads%(<|>)/ contained nextgroup=asemeClause_310,asemeComment_312 skipwhite skipempty
syntax region asemeComment_312 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_310,asemeComment_312 skipwhite skipempty
syntax match asemeComment_312 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_310,asemeComment_312 skipwhite skipempty
syntax match asemeClause_310 /\vto%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeClause_308 /\vor%(<|>)/ contained nextgroup=asemeName_307,asemeComment_309 skipwhite skipempty
syntax region asemeComment_309 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_307,asemeComment_309 skipwhite skipempty
syntax match asemeComment_309 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_307,asemeComment_309 skipwhite skipempty
syntax match asemeName_307 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeClause_305 /\vat%(<|>)/ contained nextgroup=asemeClause_303,asemeComment_306 skipwhite skipempty
syntax region asemeComment_306 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeClause_303,asemeComment_306 skipwhite skipempty
syntax match asemeComment_306 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeClause_303,asemeComment_306 skipwhite skipempty
syntax match asemeClause_303 /\vmost%(<|>)/ contained nextgroup=asemeChoice_300,asemeNumber_302,asemeComment_304 skipwhite skipempty
syntax region asemeComment_304 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeChoice_300,asemeNumber_302,asemeComment_304 skipwhite skipempty
syntax match asemeComment_304 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeChoice_300,asemeNumber_302,asemeComment_304 skipwhite skipempty
syntax match asemeNumber_302 /\v%(one|two|three|[0-9]+)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeChoice_300 /\v%(one|two|three)%(<|>)/ contained nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax region asemeComment_301 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeComment_301 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeClauseInBodyOfAip,asemeComment_301 skipwhite skipempty
syntax match asemeDeclaration_298 /\v%(outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=)@=outcome%(<|>)/ contained nextgroup=asemeText_297,asemeComment_299 skipwhite skipempty
syntax region asemeComment_299 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeText_297,asemeComment_299 skipwhite skipempty
syntax match asemeComment_299 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeText_297,asemeComment_299 skipwhite skipempty
syntax match asemeText_297 /\v\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell
syntax match asemeDeclaration_295 /\v%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=participant%(<|>)/ contained nextgroup=asemeBlock_294,asemeComment_296 skipwhite skipempty
syntax region asemeComment_296 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBlock_294,asemeComment_296 skipwhite skipempty
syntax match asemeComment_296 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBlock_294,asemeComment_296 skipwhite skipempty
syntax match asemeBlock_294 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax cluster asemeParticipantInBodyOfAip contains=asemePunctuation_190,asemePunctuation_193,asemePunctuation_195,asemePunctuation_292,asemeBlock_293
syntax match asemeBlock_293 /\v%(%(participant%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|outcome%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|clause%(<|>)%(\_s*%(at%(<|>)|every%(<|>)|\(|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|control%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeParticipantInBodyOfAip,asemeComment_189 skipwhite skipempty
syntax region asemePunctuation_292 matchgroup=asemePunctuation start=/{/ end=/}/ contained transparent fold contains=@asemeBodyOfParticipant
syntax cluster asemeBodyOfParticipant contains=asemeDeclaration_197,asemeDeclaration_236,asemeDeclaration_241,asemeDeclaration_255,asemeDeclaration_269,asemeName_291,asemeText_38,asemeText_39,asemeNumber_40,asemeReference_41,asemeReference_42,asemePunctuation_43,asemeComment
syntax match asemeName_291 /\v%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax cluster asemeProcessInBodyOfParticipant contains=asemePunctuation_273,asemePunctuation_277,asemePunctuation_280,asemePunctuation_282,asemeOperator_290
syntax match asemeOperator_290 /\v\=%(\=)@!/ contained nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax cluster asemeProcessToken contains=asemeText_283,asemeNumber_285,asemeReference_286,asemeNumber_287,asemeOperator_288,asemePunctuation_289
syntax match asemePunctuation_289 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemeOperator_288 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=%(\|\||\&\&|\-\>|\[\>|[.|*+~\^&ω])/ contained nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemeNumber_287 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]\w*/ contained nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemeReference_286 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[A-Za-z_][A-Za-z0-9_]*/ contained nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemeNumber_285 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemeText_283 /\v%(%(%(\|\||\[\>|\^?ω|\&\&|\-\>|\?\w*\?|%(%(engage|var|let|sends|receives|process|participant|outcome|clause|control)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=%(\=)@!|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=%(\=)@!|\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|[0-9]\w*|\"%([^"\\\n]|\\.)*\"|[^ \t{}"0-9A-Za-z_])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax region asemeComment_284 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemeComment_284 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessToken,asemeComment_284 skipwhite skipempty
syntax match asemePunctuation_282 /\v\)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax match asemePunctuation_280 /\v\,/ contained nextgroup=asemeName_279,asemeComment_281 skipwhite skipempty
syntax region asemeComment_281 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_279,asemeComment_281 skipwhite skipempty
syntax match asemeComment_281 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_279,asemeComment_281 skipwhite skipempty
syntax match asemeName_279 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax match asemePunctuation_277 /\v\:/ contained nextgroup=asemeBuiltIn_275,asemeType_276,asemeComment_278 skipwhite skipempty
syntax region asemeComment_278 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_275,asemeType_276,asemeComment_278 skipwhite skipempty
syntax match asemeComment_278 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_275,asemeType_276,asemeComment_278 skipwhite skipempty
syntax match asemeType_276 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax match asemeBuiltIn_275 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax match asemePunctuation_273 /\v\(/ contained nextgroup=asemeName_271,asemeComment_274 skipwhite skipempty
syntax region asemeComment_274 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_271,asemeComment_274 skipwhite skipempty
syntax match asemeComment_274 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_271,asemeComment_274 skipwhite skipempty
syntax match asemeName_271 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax region asemeComment_272 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax match asemeComment_272 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeProcessInBodyOfParticipant,asemeComment_272 skipwhite skipempty
syntax match asemeDeclaration_269 /\v%(receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=receives%(<|>)/ contained nextgroup=asemeReference_267,asemeComment_270 skipwhite skipempty
syntax region asemeComment_270 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_267,asemeComment_270 skipwhite skipempty
syntax match asemeComment_270 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_267,asemeComment_270 skipwhite skipempty
syntax match asemeReference_267 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax region asemeComment_268 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax match asemeComment_268 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_266,asemeComment_268 skipwhite skipempty
syntax match asemeReference_266 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax cluster asemeReceivesInBodyOfParticipant contains=asemePunctuation_261,asemeReference_264
syntax match asemeReference_264 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_263,@asemeReceivesInBodyOfParticipant,asemeComment_265 skipwhite skipempty
syntax region asemeComment_265 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_263,@asemeReceivesInBodyOfParticipant,asemeComment_265 skipwhite skipempty
syntax match asemeComment_265 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_263,@asemeReceivesInBodyOfParticipant,asemeComment_265 skipwhite skipempty
syntax match asemeReference_263 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemePunctuation_261 /\v\,/ contained nextgroup=asemeReference_259,asemeComment_262 skipwhite skipempty
syntax region asemeComment_262 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_259,asemeComment_262 skipwhite skipempty
syntax match asemeComment_262 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_259,asemeComment_262 skipwhite skipempty
syntax match asemeReference_259 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_257,asemeComment_260 skipwhite skipempty
syntax region asemeComment_260 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_257,asemeComment_260 skipwhite skipempty
syntax match asemeComment_260 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_257,asemeComment_260 skipwhite skipempty
syntax match asemeReference_257 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax region asemeComment_258 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeComment_258 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeReceivesInBodyOfParticipant,asemeComment_258 skipwhite skipempty
syntax match asemeDeclaration_255 /\v%(sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=)@=sends%(<|>)/ contained nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax region asemeComment_256 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax match asemeComment_256 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_253,asemeComment_256 skipwhite skipempty
syntax match asemeReference_253 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_252,asemeComment_254 skipwhite skipempty
syntax region asemeComment_254 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_252,asemeComment_254 skipwhite skipempty
syntax match asemeComment_254 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_252,asemeComment_254 skipwhite skipempty
syntax match asemeReference_252 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax cluster asemeSendsInBodyOfParticipant contains=asemePunctuation_247,asemeReference_250
syntax match asemeReference_250 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=asemeReference_249,@asemeSendsInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax region asemeComment_251 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_249,@asemeSendsInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeComment_251 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_249,@asemeSendsInBodyOfParticipant,asemeComment_251 skipwhite skipempty
syntax match asemeReference_249 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax match asemePunctuation_247 /\v\,/ contained nextgroup=asemeReference_245,asemeComment_248 skipwhite skipempty
syntax region asemeComment_248 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_245,asemeComment_248 skipwhite skipempty
syntax match asemeComment_248 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_245,asemeComment_248 skipwhite skipempty
syntax match asemeReference_245 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!%(\_s*%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!)@=/ contained nextgroup=asemeReference_243,asemeComment_246 skipwhite skipempty
syntax region asemeComment_246 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeReference_243,asemeComment_246 skipwhite skipempty
syntax match asemeComment_246 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeReference_243,asemeComment_246 skipwhite skipempty
syntax match asemeReference_243 /\v%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!/ contained nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax region asemeComment_244 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax match asemeComment_244 /\v\/\/.*$/ contained contains=@Spell nextgroup=@asemeSendsInBodyOfParticipant,asemeComment_244 skipwhite skipempty
syntax match asemeDeclaration_241 /\v%(let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=let%(<|>)/ contained nextgroup=asemeName_239,asemeComment_242 skipwhite skipempty
syntax region asemeComment_242 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_239,asemeComment_242 skipwhite skipempty
syntax match asemeComment_242 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_239,asemeComment_242 skipwhite skipempty
syntax match asemeName_239 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_238,asemeComment_240 skipwhite skipempty
syntax region asemeComment_240 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_238,asemeComment_240 skipwhite skipempty
syntax match asemeComment_240 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_238,asemeComment_240 skipwhite skipempty
syntax match asemeOperator_238 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeDeclaration_236 /\v%(var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=)@=var%(<|>)/ contained nextgroup=asemeName_234,asemeComment_237 skipwhite skipempty
syntax region asemeComment_237 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_234,asemeComment_237 skipwhite skipempty
syntax match asemeComment_237 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_234,asemeComment_237 skipwhite skipempty
syntax match asemeName_234 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_232,asemeComment_235 skipwhite skipempty
syntax region asemeComment_235 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_232,asemeComment_235 skipwhite skipempty
syntax match asemeComment_235 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_232,asemeComment_235 skipwhite skipempty
syntax match asemePunctuation_232 /\v\:/ contained nextgroup=asemeBuiltIn_230,asemeType_231,asemeComment_233 skipwhite skipempty
syntax region asemeComment_233 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_230,asemeType_231,asemeComment_233 skipwhite skipempty
syntax match asemeComment_233 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_230,asemeType_231,asemeComment_233 skipwhite skipempty
syntax match asemeType_231 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_230 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax cluster asemeVarInBodyOfParticipant contains=asemePunctuation_202,asemeOperator_221,asemeName_226,asemeBuiltIn_228,asemeType_229
syntax match asemeType_229 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_228 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeName_226 /\v%(%(engage%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|var%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sends%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|receives%(<|>)%(\_s*%(%(%(engage|var|let|sends|receives|process)%(<|>))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\=|\_s*\([0-9A-Za-z_ \t,:]*\)\_s*\=))@!|%($|\/\/|\/\*)))@=|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*%(\(|\=%(\=)@!))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\:)@=/ contained nextgroup=asemePunctuation_224,asemeComment_227 skipwhite skipempty
syntax region asemeComment_227 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_224,asemeComment_227 skipwhite skipempty
syntax match asemeComment_227 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_224,asemeComment_227 skipwhite skipempty
syntax match asemePunctuation_224 /\v\:/ contained nextgroup=asemeBuiltIn_222,asemeType_223,asemeComment_225 skipwhite skipempty
syntax region asemeComment_225 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_222,asemeType_223,asemeComment_225 skipwhite skipempty
syntax match asemeComment_225 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_222,asemeType_223,asemeComment_225 skipwhite skipempty
syntax match asemeType_223 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeBuiltIn_222 /\v%(bool|int|double|string|bytes|duration)%(<|>)/ contained nextgroup=@asemeVarInBodyOfParticipant,asemeComment_200 skipwhite skipempty
syntax match asemeOperator_221 /\v\=%(\=)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax cluster asemeExpressionToken contains=asemeText_204,asemeNumber_206,asemeTruth_207,asemeLogic_208,asemeClause_209,asemeClause_210,asemeClause_211,asemeClause_212,asemeClause_213,asemeClause_214,asemeClause_215,asemeClause_216,asemeCall_217,asemeReference_218,asemeOperator_219,asemePunctuation_220
syntax match asemePunctuation_220 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeOperator_219 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeReference_218 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeCall_217 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_216 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_215 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_214 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_213 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_212 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_211 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_210 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeClause_209 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeLogic_208 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeTruth_207 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeNumber_206 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
syntax match asemeText_204 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeExpressionToken,asemeComment_205 skipwhite skipempty
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
syntax match asemeName_129 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_128,asemeComment_130 skipwhite skipempty
syntax region asemeComment_130 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_128,asemeComment_130 skipwhite skipempty
syntax match asemeComment_130 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_128,asemeComment_130 skipwhite skipempty
syntax match asemePunctuation_128 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax cluster asemeFunctionInFile contains=asemePunctuation_112,asemePunctuation_118,asemePunctuation_120,asemeBuiltIn_122,asemeType_124,asemeName_126
syntax match asemeName_126 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\()@=/ contained nextgroup=asemePunctuation_125,asemeComment_127 skipwhite skipempty
syntax region asemeComment_127 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_125,asemeComment_127 skipwhite skipempty
syntax match asemeComment_127 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_125,asemeComment_127 skipwhite skipempty
syntax match asemePunctuation_125 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemeType_124 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax match asemeBuiltIn_122 /\v%(%(language%(<|>)%(\_s*%([0-9]+%(%(\w|\.[0-9]))@!|%($|\/\/|\/\*)))@=|system%(<|>)%(\_s*%(%(%(%(%(import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team)\_s*[0-9A-Za-z_{"]|abstract\_s+srm%(<|>)))@![A-Za-z_][A-Za-z0-9_]*%(<|>))|%($|\/\/|\/\*)))@=|import%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|let%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|enum%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|message%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|topic%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|function%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|sag%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|suc%(<|>)%(\_s*%(\{|%($|\/\/|\/\*)))@=|aip%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|%(abstract%(<|>)|srm%(<|>))%(\_s*%(srm%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|statechart%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|team%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)|%($|\/\/|\/\*)))@=|scenario%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=|property%(<|>)%(\_s*%(\"%([^"\\\n]|\\.)*\"|%($|\/\/|\/\*)))@=))@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax region asemeComment_123 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax match asemeComment_123 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_121,asemeComment_123 skipwhite skipempty
syntax match asemeName_121 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemePunctuation_120 /\v\(/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemePunctuation_118 /\v\,/ contained nextgroup=asemeBuiltIn_115,asemeType_117,asemeComment_119 skipwhite skipempty
syntax region asemeComment_119 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_115,asemeType_117,asemeComment_119 skipwhite skipempty
syntax match asemeComment_119 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_115,asemeType_117,asemeComment_119 skipwhite skipempty
syntax match asemeType_117 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax match asemeBuiltIn_115 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>))@=/ contained nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax region asemeComment_116 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax match asemeComment_116 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_114,asemeComment_116 skipwhite skipempty
syntax match asemeName_114 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)/ contained nextgroup=@asemeFunctionInFile,asemeComment_104 skipwhite skipempty
syntax match asemePunctuation_112 /\v\)/ contained nextgroup=asemePunctuation_110,asemeComment_113 skipwhite skipempty
syntax region asemeComment_113 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemePunctuation_110,asemeComment_113 skipwhite skipempty
syntax match asemeComment_113 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemePunctuation_110,asemeComment_113 skipwhite skipempty
syntax match asemePunctuation_110 /\v\:/ contained nextgroup=asemeBuiltIn_107,asemeType_109,asemeComment_111 skipwhite skipempty
syntax region asemeComment_111 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_107,asemeType_109,asemeComment_111 skipwhite skipempty
syntax match asemeComment_111 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_107,asemeType_109,asemeComment_111 skipwhite skipempty
syntax match asemeType_109 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_105,asemeComment_108 skipwhite skipempty
syntax match asemeBuiltIn_107 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_105,asemeComment_108 skipwhite skipempty
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
syntax match asemeType_69 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax match asemeBuiltIn_67 /\v%(%(%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@=%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax region asemeComment_68 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax match asemeComment_68 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_66,asemeComment_68 skipwhite skipempty
syntax match asemeName_66 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeDeclaration_64 /\v%(%(optional|repeated)%(<|>)%(\_s*%([A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|%($|\/\/|\/\*)))@=)@=%(optional|repeated)%(<|>)/ contained nextgroup=asemeBuiltIn_61,asemeType_63,asemeComment_65 skipwhite skipempty
syntax region asemeComment_65 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeBuiltIn_61,asemeType_63,asemeComment_65 skipwhite skipempty
syntax match asemeComment_65 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeBuiltIn_61,asemeType_63,asemeComment_65 skipwhite skipempty
syntax match asemeType_63 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax match asemeBuiltIn_61 /\v%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax region asemeComment_62 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax match asemeComment_62 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeName_60,asemeComment_62 skipwhite skipempty
syntax match asemeName_60 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax cluster asemeFieldInBodyOfMessage contains=asemeOperator_52,asemePunctuation_54,asemeBuiltIn_56,asemeType_58,asemeName_59
syntax match asemeName_59 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!/ contained nextgroup=@asemeFieldInBodyOfMessage,asemeComment_51 skipwhite skipempty
syntax match asemeType_58 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@![A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_55,asemeComment_57 skipwhite skipempty
syntax match asemeBuiltIn_56 /\v%(%(%(optional|repeated)%(<|>)|%(bool|int|double|string|bytes|duration)%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=)@!%(bool|int|double|string|bytes|duration)%(<|>)%(\_s*[A-Za-z_][A-Za-z0-9_]*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!)@=/ contained nextgroup=asemeName_55,asemeComment_57 skipwhite skipempty
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
syntax match asemeName_28 /\v[A-Za-z_][A-Za-z0-9_]*%(<|>)%(\_s*\=%(\=)@!)@=/ contained nextgroup=asemeOperator_27,asemeComment_29 skipwhite skipempty
syntax region asemeComment_29 start=/\v\/\*/ end=/\v\*\// contained contains=@Spell nextgroup=asemeOperator_27,asemeComment_29 skipwhite skipempty
syntax match asemeComment_29 /\v\/\/.*$/ contained contains=@Spell nextgroup=asemeOperator_27,asemeComment_29 skipwhite skipempty
syntax match asemeOperator_27 /\v\=%(\=)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax cluster asemeLet contains=asemeText_10,asemeNumber_12,asemeTruth_13,asemeLogic_14,asemeClause_15,asemeClause_16,asemeClause_17,asemeClause_18,asemeClause_19,asemeClause_20,asemeClause_21,asemeClause_22,asemeCall_23,asemeReference_24,asemeOperator_25,asemePunctuation_26
syntax match asemePunctuation_26 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[^ \t0-9A-Za-z_{}]/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeOperator_25 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(\&\&|\|\||[<>=!]\=|\-\>|\.\.|[\-+*\/%<>=!?#@~|&\^])/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeReference_24 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%([ \t]*\.[ \t]*[A-Za-z_][A-Za-z0-9_]*)*/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeCall_23 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[A-Za-z_][A-Za-z0-9_]*%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_22 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=write_messages%(<|>)%(\_s*\.)@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_21 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=read_messages%(<|>)%(\_s*\()@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_20 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=to%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_19 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=from%(<|>)%(\_s+%(%(and|or)%(<|>))@![A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_18 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=send%(<|>)%(\_s+[A-Za-z_])@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_17 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=after%(<|>)%(\_s*\()@=/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_16 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=when%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeClause_15 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=else%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeLogic_14 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(and|or|not)%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeTruth_13 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=%(true|false)%(<|>)%(\_s*\.)@!/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeNumber_12 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)/ contained nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
syntax match asemeText_10 /\v%(%(%(%(%(outcome|engage|scenario|property|import)\_s*\"|%(liveness|activities|modules|sag|suc)\_s*\{|abstract\_s+srm\_s|%(let|var|control|participant|clause|sends|receives|includes|plays|capability|functionality|system|import|enum|message|topic|function|aip|srm|statechart|team)\_s+%(%(and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process|includes|plays|capability|liveness|activities|modules|functionality|state)%(<|>))@![A-Za-z_]|clause\_s*\(|%(state|language)\_s+[0-9]|[A-Za-z_][A-Za-z0-9_]*\_s*%(\([0-9A-Za-z_ \t,:]*\)\_s*)?\=%(\=)@!|[0-9]+%(\.[0-9]+)*\_s*\-\>))@!%(\"%([^"\\\n]|\\.)*\"|[0-9]+%(\.[0-9]+)*[A-Za-z]*%(<|>)|[A-Za-z_][A-Za-z0-9_]*%(\_s*\.\_s*[A-Za-z_][A-Za-z0-9_]*)*%(<|>)%(%(\_s*\{|\_s+%(%(liveness|activities|modules|sag|suc)%(<|>))@!\w+\_s*\{))@!|\&\&|\|\||[<>=!]\=|\-\>|\?\w*\?|[^ \t{}"0-9A-Za-z_:])))@=\"%([^"\\\n]|\\.)*\"/ contained contains=@Spell nextgroup=@asemeLet,asemeComment_11 skipwhite skipempty
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
highlight default link asemeBlock_293 asemeBlock
highlight default link asemeBlock_294 asemeBlock
highlight default link asemeBlock_392 asemeBlock
highlight default link asemeBlock_395 asemeBlock
highlight default link asemeBlock_400 asemeBlock
highlight default link asemeBlock_402 asemeBlock
highlight default link asemeBlock_405 asemeBlock
highlight default link asemeBlock_45 asemeBlock
highlight default link asemeBlock_47 asemeBlock
highlight default link asemeBlock_626 asemeBlock
highlight default link asemeBlock_628 asemeBlock
highlight default link asemeBlock_634 asemeBlock
highlight default link asemeBlock_637 asemeBlock
highlight default link asemeBlock_642 asemeBlock
highlight default link asemeBlock_643 asemeBlock
highlight default link asemeBlock_648 asemeBlock
highlight default link asemeBlock_71 asemeBlock
highlight default link asemeBlock_714 asemeBlock
highlight default link asemeBlock_716 asemeBlock
highlight default link asemeBlock_73 asemeBlock
highlight default link asemeBlock_737 asemeBlock
highlight default link asemeBlock_739 asemeBlock
highlight default link asemeBlock_99 asemeBlock
highlight default link asemeBuiltIn_107 asemeBuiltIn
highlight default link asemeBuiltIn_115 asemeBuiltIn
highlight default link asemeBuiltIn_122 asemeBuiltIn
highlight default link asemeBuiltIn_199 asemeBuiltIn
highlight default link asemeBuiltIn_222 asemeBuiltIn
highlight default link asemeBuiltIn_228 asemeBuiltIn
highlight default link asemeBuiltIn_230 asemeBuiltIn
highlight default link asemeBuiltIn_275 asemeBuiltIn
highlight default link asemeBuiltIn_469 asemeBuiltIn
highlight default link asemeBuiltIn_475 asemeBuiltIn
highlight default link asemeBuiltIn_481 asemeBuiltIn
highlight default link asemeBuiltIn_483 asemeBuiltIn
highlight default link asemeBuiltIn_500 asemeBuiltIn
highlight default link asemeBuiltIn_551 asemeBuiltIn
highlight default link asemeBuiltIn_559 asemeBuiltIn
highlight default link asemeBuiltIn_56 asemeBuiltIn
highlight default link asemeBuiltIn_61 asemeBuiltIn
highlight default link asemeBuiltIn_67 asemeBuiltIn
highlight default link asemeBuiltIn_682 asemeBuiltIn
highlight default link asemeBuiltIn_688 asemeBuiltIn
highlight default link asemeBuiltIn_694 asemeBuiltIn
highlight default link asemeBuiltIn_696 asemeBuiltIn
highlight default link asemeCall_217 asemeCall
highlight default link asemeCall_23 asemeCall
highlight default link asemeCall_352 asemeCall
highlight default link asemeCall_377 asemeCall
highlight default link asemeChoice_160 asemeChoice
highlight default link asemeChoice_300 asemeChoice
highlight default link asemeChoice_522 asemeChoice
highlight default link asemeChoice_536 asemeChoice
highlight default link asemeChoice_566 asemeChoice
highlight default link asemeChoice_579 asemeChoice
highlight default link asemeChoice_593 asemeChoice
highlight default link asemeChoice_609 asemeChoice
highlight default link asemeChoice_657 asemeChoice
highlight default link asemeChoice_661 asemeChoice
highlight default link asemeChoice_669 asemeChoice
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
highlight default link asemeClause_303 asemeClause
highlight default link asemeClause_305 asemeClause
highlight default link asemeClause_308 asemeClause
highlight default link asemeClause_310 asemeClause
highlight default link asemeClause_311 asemeClause
highlight default link asemeClause_314 asemeClause
highlight default link asemeClause_316 asemeClause
highlight default link asemeClause_317 asemeClause
highlight default link asemeClause_334 asemeClause
highlight default link asemeClause_344 asemeClause
highlight default link asemeClause_345 asemeClause
highlight default link asemeClause_346 asemeClause
highlight default link asemeClause_347 asemeClause
highlight default link asemeClause_348 asemeClause
highlight default link asemeClause_349 asemeClause
highlight default link asemeClause_350 asemeClause
highlight default link asemeClause_351 asemeClause
highlight default link asemeClause_369 asemeClause
highlight default link asemeClause_370 asemeClause
highlight default link asemeClause_371 asemeClause
highlight default link asemeClause_372 asemeClause
highlight default link asemeClause_373 asemeClause
highlight default link asemeClause_374 asemeClause
highlight default link asemeClause_375 asemeClause
highlight default link asemeClause_376 asemeClause
highlight default link asemeClause_407 asemeClause
highlight default link asemeClause_423 asemeClause
highlight default link asemeClause_426 asemeClause
highlight default link asemeClause_525 asemeClause
highlight default link asemeClause_528 asemeClause
highlight default link asemeClause_531 asemeClause
highlight default link asemeClause_534 asemeClause
highlight default link asemeClause_537 asemeClause
highlight default link asemeClause_540 asemeClause
highlight default link asemeClause_543 asemeClause
highlight default link asemeClause_546 asemeClause
highlight default link asemeClause_549 asemeClause
highlight default link asemeClause_582 asemeClause
highlight default link asemeClause_585 asemeClause
highlight default link asemeClause_588 asemeClause
highlight default link asemeClause_591 asemeClause
highlight default link asemeClause_594 asemeClause
highlight default link asemeClause_597 asemeClause
highlight default link asemeClause_600 asemeClause
highlight default link asemeClause_603 asemeClause
highlight default link asemeClause_606 asemeClause
highlight default link asemeClause_644 asemeClause
highlight default link asemeClause_653 asemeClause
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
highlight default link asemeComment_274 asemeComment
highlight default link asemeComment_278 asemeComment
highlight default link asemeComment_281 asemeComment
highlight default link asemeComment_284 asemeComment
highlight default link asemeComment_29 asemeComment
highlight default link asemeComment_296 asemeComment
highlight default link asemeComment_299 asemeComment
highlight default link asemeComment_301 asemeComment
highlight default link asemeComment_304 asemeComment
highlight default link asemeComment_306 asemeComment
highlight default link asemeComment_309 asemeComment
highlight default link asemeComment_31 asemeComment
highlight default link asemeComment_312 asemeComment
highlight default link asemeComment_315 asemeComment
highlight default link asemeComment_320 asemeComment
highlight default link asemeComment_323 asemeComment
highlight default link asemeComment_329 asemeComment
highlight default link asemeComment_33 asemeComment
highlight default link asemeComment_331 asemeComment
highlight default link asemeComment_333 asemeComment
highlight default link asemeComment_335 asemeComment
highlight default link asemeComment_338 asemeComment
highlight default link asemeComment_340 asemeComment
highlight default link asemeComment_35 asemeComment
highlight default link asemeComment_365 asemeComment
highlight default link asemeComment_383 asemeComment
highlight default link asemeComment_385 asemeComment
highlight default link asemeComment_387 asemeComment
highlight default link asemeComment_390 asemeComment
highlight default link asemeComment_393 asemeComment
highlight default link asemeComment_396 asemeComment
highlight default link asemeComment_398 asemeComment
highlight default link asemeComment_401 asemeComment
highlight default link asemeComment_404 asemeComment
highlight default link asemeComment_406 asemeComment
highlight default link asemeComment_408 asemeComment
highlight default link asemeComment_410 asemeComment
highlight default link asemeComment_412 asemeComment
highlight default link asemeComment_416 asemeComment
highlight default link asemeComment_418 asemeComment
highlight default link asemeComment_420 asemeComment
highlight default link asemeComment_422 asemeComment
highlight default link asemeComment_424 asemeComment
highlight default link asemeComment_427 asemeComment
highlight default link asemeComment_430 asemeComment
highlight default link asemeComment_433 asemeComment
highlight default link asemeComment_435 asemeComment
highlight default link asemeComment_437 asemeComment
highlight default link asemeComment_440 asemeComment
highlight default link asemeComment_443 asemeComment
highlight default link asemeComment_445 asemeComment
highlight default link asemeComment_448 asemeComment
highlight default link asemeComment_450 asemeComment
highlight default link asemeComment_452 asemeComment
highlight default link asemeComment_454 asemeComment
highlight default link asemeComment_456 asemeComment
highlight default link asemeComment_459 asemeComment
highlight default link asemeComment_46 asemeComment
highlight default link asemeComment_463 asemeComment
highlight default link asemeComment_466 asemeComment
highlight default link asemeComment_468 asemeComment
highlight default link asemeComment_470 asemeComment
highlight default link asemeComment_473 asemeComment
highlight default link asemeComment_478 asemeComment
highlight default link asemeComment_480 asemeComment
highlight default link asemeComment_486 asemeComment
highlight default link asemeComment_488 asemeComment
highlight default link asemeComment_49 asemeComment
highlight default link asemeComment_490 asemeComment
highlight default link asemeComment_493 asemeComment
highlight default link asemeComment_495 asemeComment
highlight default link asemeComment_497 asemeComment
highlight default link asemeComment_499 asemeComment
highlight default link asemeComment_5 asemeComment
highlight default link asemeComment_503 asemeComment
highlight default link asemeComment_506 asemeComment
highlight default link asemeComment_509 asemeComment
highlight default link asemeComment_51 asemeComment
highlight default link asemeComment_519 asemeComment
highlight default link asemeComment_521 asemeComment
highlight default link asemeComment_523 asemeComment
highlight default link asemeComment_526 asemeComment
highlight default link asemeComment_529 asemeComment
highlight default link asemeComment_53 asemeComment
highlight default link asemeComment_532 asemeComment
highlight default link asemeComment_535 asemeComment
highlight default link asemeComment_538 asemeComment
highlight default link asemeComment_541 asemeComment
highlight default link asemeComment_544 asemeComment
highlight default link asemeComment_547 asemeComment
highlight default link asemeComment_550 asemeComment
highlight default link asemeComment_554 asemeComment
highlight default link asemeComment_556 asemeComment
highlight default link asemeComment_558 asemeComment
highlight default link asemeComment_562 asemeComment
highlight default link asemeComment_564 asemeComment
highlight default link asemeComment_567 asemeComment
highlight default link asemeComment_57 asemeComment
highlight default link asemeComment_571 asemeComment
highlight default link asemeComment_576 asemeComment
highlight default link asemeComment_578 asemeComment
highlight default link asemeComment_580 asemeComment
highlight default link asemeComment_583 asemeComment
highlight default link asemeComment_586 asemeComment
highlight default link asemeComment_589 asemeComment
highlight default link asemeComment_592 asemeComment
highlight default link asemeComment_595 asemeComment
highlight default link asemeComment_598 asemeComment
highlight default link asemeComment_601 asemeComment
highlight default link asemeComment_604 asemeComment
highlight default link asemeComment_607 asemeComment
highlight default link asemeComment_610 asemeComment
highlight default link asemeComment_614 asemeComment
highlight default link asemeComment_617 asemeComment
highlight default link asemeComment_62 asemeComment
highlight default link asemeComment_621 asemeComment
highlight default link asemeComment_624 asemeComment
highlight default link asemeComment_627 asemeComment
highlight default link asemeComment_630 asemeComment
highlight default link asemeComment_632 asemeComment
highlight default link asemeComment_635 asemeComment
highlight default link asemeComment_638 asemeComment
highlight default link asemeComment_640 asemeComment
highlight default link asemeComment_645 asemeComment
highlight default link asemeComment_647 asemeComment
highlight default link asemeComment_65 asemeComment
highlight default link asemeComment_650 asemeComment
highlight default link asemeComment_652 asemeComment
highlight default link asemeComment_654 asemeComment
highlight default link asemeComment_658 asemeComment
highlight default link asemeComment_662 asemeComment
highlight default link asemeComment_664 asemeComment
highlight default link asemeComment_670 asemeComment
highlight default link asemeComment_672 asemeComment
highlight default link asemeComment_674 asemeComment
highlight default link asemeComment_677 asemeComment
highlight default link asemeComment_679 asemeComment
highlight default link asemeComment_68 asemeComment
highlight default link asemeComment_681 asemeComment
highlight default link asemeComment_683 asemeComment
highlight default link asemeComment_686 asemeComment
highlight default link asemeComment_691 asemeComment
highlight default link asemeComment_693 asemeComment
highlight default link asemeComment_699 asemeComment
highlight default link asemeComment_701 asemeComment
highlight default link asemeComment_703 asemeComment
highlight default link asemeComment_706 asemeComment
highlight default link asemeComment_708 asemeComment
highlight default link asemeComment_710 asemeComment
highlight default link asemeComment_712 asemeComment
highlight default link asemeComment_715 asemeComment
highlight default link asemeComment_718 asemeComment
highlight default link asemeComment_72 asemeComment
highlight default link asemeComment_720 asemeComment
highlight default link asemeComment_722 asemeComment
highlight default link asemeComment_724 asemeComment
highlight default link asemeComment_726 asemeComment
highlight default link asemeComment_728 asemeComment
highlight default link asemeComment_731 asemeComment
highlight default link asemeComment_734 asemeComment
highlight default link asemeComment_738 asemeComment
highlight default link asemeComment_741 asemeComment
highlight default link asemeComment_75 asemeComment
highlight default link asemeComment_767 asemeComment
highlight default link asemeComment_77 asemeComment
highlight default link asemeComment_770 asemeComment
highlight default link asemeComment_778 asemeComment
highlight default link asemeComment_781 asemeComment
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
highlight default link asemeDeclaration_295 asemeDeclaration
highlight default link asemeDeclaration_298 asemeDeclaration
highlight default link asemeDeclaration_30 asemeDeclaration
highlight default link asemeDeclaration_326 asemeDeclaration
highlight default link asemeDeclaration_330 asemeDeclaration
highlight default link asemeDeclaration_363 asemeDeclaration
highlight default link asemeDeclaration_397 asemeDeclaration
highlight default link asemeDeclaration_4 asemeDeclaration
highlight default link asemeDeclaration_403 asemeDeclaration
highlight default link asemeDeclaration_415 asemeDeclaration
highlight default link asemeDeclaration_451 asemeDeclaration
highlight default link asemeDeclaration_467 asemeDeclaration
highlight default link asemeDeclaration_48 asemeDeclaration
highlight default link asemeDeclaration_489 asemeDeclaration
highlight default link asemeDeclaration_494 asemeDeclaration
highlight default link asemeDeclaration_518 asemeDeclaration
highlight default link asemeDeclaration_575 asemeDeclaration
highlight default link asemeDeclaration_620 asemeDeclaration
highlight default link asemeDeclaration_623 asemeDeclaration
highlight default link asemeDeclaration_629 asemeDeclaration
highlight default link asemeDeclaration_639 asemeDeclaration
highlight default link asemeDeclaration_64 asemeDeclaration
highlight default link asemeDeclaration_646 asemeDeclaration
highlight default link asemeDeclaration_649 asemeDeclaration
highlight default link asemeDeclaration_673 asemeDeclaration
highlight default link asemeDeclaration_702 asemeDeclaration
highlight default link asemeDeclaration_707 asemeDeclaration
highlight default link asemeDeclaration_709 asemeDeclaration
highlight default link asemeDeclaration_711 asemeDeclaration
highlight default link asemeDeclaration_717 asemeDeclaration
highlight default link asemeDeclaration_74 asemeDeclaration
highlight default link asemeDeclaration_740 asemeDeclaration
highlight default link asemeDeclaration_769 asemeDeclaration
highlight default link asemeDeclaration_780 asemeDeclaration
highlight default link asemeDeclaration_8 asemeDeclaration
highlight default link asemeDeclaration_96 asemeDeclaration
highlight default link asemeLogic_14 asemeLogic
highlight default link asemeLogic_208 asemeLogic
highlight default link asemeLogic_343 asemeLogic
highlight default link asemeLogic_368 asemeLogic
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
highlight default link asemeName_271 asemeName
highlight default link asemeName_279 asemeName
highlight default link asemeName_28 asemeName
highlight default link asemeName_291 asemeName
highlight default link asemeName_3 asemeName
highlight default link asemeName_307 asemeName
highlight default link asemeName_318 asemeName
highlight default link asemeName_325 asemeName
highlight default link asemeName_328 asemeName
highlight default link asemeName_37 asemeName
highlight default link asemeName_462 asemeName
highlight default link asemeName_465 asemeName
highlight default link asemeName_479 asemeName
highlight default link asemeName_487 asemeName
highlight default link asemeName_492 asemeName
highlight default link asemeName_496 asemeName
highlight default link asemeName_504 asemeName
highlight default link asemeName_516 asemeName
highlight default link asemeName_55 asemeName
highlight default link asemeName_555 asemeName
highlight default link asemeName_563 asemeName
highlight default link asemeName_573 asemeName
highlight default link asemeName_59 asemeName
highlight default link asemeName_60 asemeName
highlight default link asemeName_618 asemeName
highlight default link asemeName_655 asemeName
highlight default link asemeName_659 asemeName
highlight default link asemeName_66 asemeName
highlight default link asemeName_665 asemeName
highlight default link asemeName_667 asemeName
highlight default link asemeName_692 asemeName
highlight default link asemeName_700 asemeName
highlight default link asemeName_705 asemeName
highlight default link asemeName_729 asemeName
highlight default link asemeName_735 asemeName
highlight default link asemeNumber_0 asemeNumber
highlight default link asemeNumber_12 asemeNumber
highlight default link asemeNumber_188 asemeNumber
highlight default link asemeNumber_192 asemeNumber
highlight default link asemeNumber_206 asemeNumber
highlight default link asemeNumber_285 asemeNumber
highlight default link asemeNumber_287 asemeNumber
highlight default link asemeNumber_302 asemeNumber
highlight default link asemeNumber_313 asemeNumber
highlight default link asemeNumber_32 asemeNumber
highlight default link asemeNumber_332 asemeNumber
highlight default link asemeNumber_336 asemeNumber
highlight default link asemeNumber_341 asemeNumber
highlight default link asemeNumber_358 asemeNumber
highlight default link asemeNumber_360 asemeNumber
highlight default link asemeNumber_366 asemeNumber
highlight default link asemeNumber_382 asemeNumber
highlight default link asemeNumber_386 asemeNumber
highlight default link asemeNumber_40 asemeNumber
highlight default link asemeNumber_50 asemeNumber
highlight default link asemeNumber_510 asemeNumber
highlight default link asemeNumber_512 asemeNumber
highlight default link asemeNumber_527 asemeNumber
highlight default link asemeNumber_530 asemeNumber
highlight default link asemeNumber_533 asemeNumber
highlight default link asemeNumber_542 asemeNumber
highlight default link asemeNumber_584 asemeNumber
highlight default link asemeNumber_587 asemeNumber
highlight default link asemeNumber_590 asemeNumber
highlight default link asemeNumber_599 asemeNumber
highlight default link asemeNumber_663 asemeNumber
highlight default link asemeNumber_671 asemeNumber
highlight default link asemeNumber_676 asemeNumber
highlight default link asemeNumber_680 asemeNumber
highlight default link asemeNumber_721 asemeNumber
highlight default link asemeNumber_725 asemeNumber
highlight default link asemeNumber_743 asemeNumber
highlight default link asemeNumber_749 asemeNumber
highlight default link asemeNumber_755 asemeNumber
highlight default link asemeNumber_761 asemeNumber
highlight default link asemeNumber_772 asemeNumber
highlight default link asemeNumber_784 asemeNumber
highlight default link asemeNumber_80 asemeNumber
highlight default link asemeNumber_87 asemeNumber
highlight default link asemeOperator_105 asemeOperator
highlight default link asemeOperator_219 asemeOperator
highlight default link asemeOperator_221 asemeOperator
highlight default link asemeOperator_238 asemeOperator
highlight default link asemeOperator_25 asemeOperator
highlight default link asemeOperator_27 asemeOperator
highlight default link asemeOperator_288 asemeOperator
highlight default link asemeOperator_290 asemeOperator
highlight default link asemeOperator_322 asemeOperator
highlight default link asemeOperator_327 asemeOperator
highlight default link asemeOperator_337 asemeOperator
highlight default link asemeOperator_34 asemeOperator
highlight default link asemeOperator_354 asemeOperator
highlight default link asemeOperator_361 asemeOperator
highlight default link asemeOperator_379 asemeOperator
highlight default link asemeOperator_384 asemeOperator
highlight default link asemeOperator_389 asemeOperator
highlight default link asemeOperator_391 asemeOperator
highlight default link asemeOperator_394 asemeOperator
highlight default link asemeOperator_419 asemeOperator
highlight default link asemeOperator_429 asemeOperator
highlight default link asemeOperator_455 asemeOperator
highlight default link asemeOperator_474 asemeOperator
highlight default link asemeOperator_491 asemeOperator
highlight default link asemeOperator_513 asemeOperator
highlight default link asemeOperator_515 asemeOperator
highlight default link asemeOperator_52 asemeOperator
highlight default link asemeOperator_616 asemeOperator
highlight default link asemeOperator_631 asemeOperator
highlight default link asemeOperator_633 asemeOperator
highlight default link asemeOperator_636 asemeOperator
highlight default link asemeOperator_678 asemeOperator
highlight default link asemeOperator_687 asemeOperator
highlight default link asemeOperator_704 asemeOperator
highlight default link asemeOperator_745 asemeOperator
highlight default link asemeOperator_751 asemeOperator
highlight default link asemeOperator_757 asemeOperator
highlight default link asemeOperator_763 asemeOperator
highlight default link asemeOperator_774 asemeOperator
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
highlight default link asemePunctuation_273 asemePunctuation
highlight default link asemePunctuation_277 asemePunctuation
highlight default link asemePunctuation_280 asemePunctuation
highlight default link asemePunctuation_282 asemePunctuation
highlight default link asemePunctuation_289 asemePunctuation
highlight default link asemePunctuation_292 asemePunctuation
highlight default link asemePunctuation_319 asemePunctuation
highlight default link asemePunctuation_324 asemePunctuation
highlight default link asemePunctuation_355 asemePunctuation
highlight default link asemePunctuation_356 asemePunctuation
highlight default link asemePunctuation_36 asemePunctuation
highlight default link asemePunctuation_362 asemePunctuation
highlight default link asemePunctuation_380 asemePunctuation
highlight default link asemePunctuation_381 asemePunctuation
highlight default link asemePunctuation_388 asemePunctuation
highlight default link asemePunctuation_399 asemePunctuation
highlight default link asemePunctuation_411 asemePunctuation
highlight default link asemePunctuation_43 asemePunctuation
highlight default link asemePunctuation_432 asemePunctuation
highlight default link asemePunctuation_436 asemePunctuation
highlight default link asemePunctuation_439 asemePunctuation
highlight default link asemePunctuation_44 asemePunctuation
highlight default link asemePunctuation_442 asemePunctuation
highlight default link asemePunctuation_447 asemePunctuation
highlight default link asemePunctuation_458 asemePunctuation
highlight default link asemePunctuation_472 asemePunctuation
highlight default link asemePunctuation_477 asemePunctuation
highlight default link asemePunctuation_485 asemePunctuation
highlight default link asemePunctuation_498 asemePunctuation
highlight default link asemePunctuation_502 asemePunctuation
highlight default link asemePunctuation_505 asemePunctuation
highlight default link asemePunctuation_507 asemePunctuation
highlight default link asemePunctuation_514 asemePunctuation
highlight default link asemePunctuation_517 asemePunctuation
highlight default link asemePunctuation_54 asemePunctuation
highlight default link asemePunctuation_553 asemePunctuation
highlight default link asemePunctuation_557 asemePunctuation
highlight default link asemePunctuation_561 asemePunctuation
highlight default link asemePunctuation_570 asemePunctuation
highlight default link asemePunctuation_572 asemePunctuation
highlight default link asemePunctuation_574 asemePunctuation
highlight default link asemePunctuation_613 asemePunctuation
highlight default link asemePunctuation_619 asemePunctuation
highlight default link asemePunctuation_625 asemePunctuation
highlight default link asemePunctuation_641 asemePunctuation
highlight default link asemePunctuation_675 asemePunctuation
highlight default link asemePunctuation_685 asemePunctuation
highlight default link asemePunctuation_690 asemePunctuation
highlight default link asemePunctuation_698 asemePunctuation
highlight default link asemePunctuation_70 asemePunctuation
highlight default link asemePunctuation_713 asemePunctuation
highlight default link asemePunctuation_719 asemePunctuation
highlight default link asemePunctuation_723 asemePunctuation
highlight default link asemePunctuation_727 asemePunctuation
highlight default link asemePunctuation_730 asemePunctuation
highlight default link asemePunctuation_733 asemePunctuation
highlight default link asemePunctuation_736 asemePunctuation
highlight default link asemePunctuation_746 asemePunctuation
highlight default link asemePunctuation_747 asemePunctuation
highlight default link asemePunctuation_752 asemePunctuation
highlight default link asemePunctuation_753 asemePunctuation
highlight default link asemePunctuation_758 asemePunctuation
highlight default link asemePunctuation_759 asemePunctuation
highlight default link asemePunctuation_764 asemePunctuation
highlight default link asemePunctuation_765 asemePunctuation
highlight default link asemePunctuation_775 asemePunctuation
highlight default link asemePunctuation_776 asemePunctuation
highlight default link asemePunctuation_787 asemePunctuation
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
highlight default link asemeReference_286 asemeReference
highlight default link asemeReference_321 asemeReference
highlight default link asemeReference_353 asemeReference
highlight default link asemeReference_359 asemeReference
highlight default link asemeReference_378 asemeReference
highlight default link asemeReference_409 asemeReference
highlight default link asemeReference_41 asemeReference
highlight default link asemeReference_413 asemeReference
highlight default link asemeReference_414 asemeReference
highlight default link asemeReference_417 asemeReference
highlight default link asemeReference_42 asemeReference
highlight default link asemeReference_421 asemeReference
highlight default link asemeReference_425 asemeReference
highlight default link asemeReference_428 asemeReference
highlight default link asemeReference_431 asemeReference
highlight default link asemeReference_434 asemeReference
highlight default link asemeReference_438 asemeReference
highlight default link asemeReference_441 asemeReference
highlight default link asemeReference_444 asemeReference
highlight default link asemeReference_446 asemeReference
highlight default link asemeReference_449 asemeReference
highlight default link asemeReference_453 asemeReference
highlight default link asemeReference_457 asemeReference
highlight default link asemeReference_511 asemeReference
highlight default link asemeReference_520 asemeReference
highlight default link asemeReference_524 asemeReference
highlight default link asemeReference_539 asemeReference
highlight default link asemeReference_545 asemeReference
highlight default link asemeReference_548 asemeReference
highlight default link asemeReference_565 asemeReference
highlight default link asemeReference_568 asemeReference
highlight default link asemeReference_569 asemeReference
highlight default link asemeReference_577 asemeReference
highlight default link asemeReference_581 asemeReference
highlight default link asemeReference_596 asemeReference
highlight default link asemeReference_6 asemeReference
highlight default link asemeReference_602 asemeReference
highlight default link asemeReference_605 asemeReference
highlight default link asemeReference_608 asemeReference
highlight default link asemeReference_611 asemeReference
highlight default link asemeReference_612 asemeReference
highlight default link asemeReference_651 asemeReference
highlight default link asemeReference_732 asemeReference
highlight default link asemeReference_744 asemeReference
highlight default link asemeReference_750 asemeReference
highlight default link asemeReference_756 asemeReference
highlight default link asemeReference_76 asemeReference
highlight default link asemeReference_762 asemeReference
highlight default link asemeReference_773 asemeReference
highlight default link asemeReference_785 asemeReference
highlight default link asemeReference_786 asemeReference
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
highlight default link asemeText_283 asemeText
highlight default link asemeText_297 asemeText
highlight default link asemeText_339 asemeText
highlight default link asemeText_357 asemeText
highlight default link asemeText_364 asemeText
highlight default link asemeText_38 asemeText
highlight default link asemeText_39 asemeText
highlight default link asemeText_460 asemeText
highlight default link asemeText_461 asemeText
highlight default link asemeText_464 asemeText
highlight default link asemeText_508 asemeText
highlight default link asemeText_615 asemeText
highlight default link asemeText_622 asemeText
highlight default link asemeText_656 asemeText
highlight default link asemeText_660 asemeText
highlight default link asemeText_666 asemeText
highlight default link asemeText_668 asemeText
highlight default link asemeText_7 asemeText
highlight default link asemeText_742 asemeText
highlight default link asemeText_748 asemeText
highlight default link asemeText_754 asemeText
highlight default link asemeText_760 asemeText
highlight default link asemeText_766 asemeText
highlight default link asemeText_768 asemeText
highlight default link asemeText_771 asemeText
highlight default link asemeText_777 asemeText
highlight default link asemeText_779 asemeText
highlight default link asemeText_782 asemeText
highlight default link asemeText_783 asemeText
highlight default link asemeTruth_13 asemeTruth
highlight default link asemeTruth_207 asemeTruth
highlight default link asemeTruth_342 asemeTruth
highlight default link asemeTruth_367 asemeTruth
highlight default link asemeType_109 asemeType
highlight default link asemeType_117 asemeType
highlight default link asemeType_124 asemeType
highlight default link asemeType_201 asemeType
highlight default link asemeType_223 asemeType
highlight default link asemeType_229 asemeType
highlight default link asemeType_231 asemeType
highlight default link asemeType_276 asemeType
highlight default link asemeType_471 asemeType
highlight default link asemeType_476 asemeType
highlight default link asemeType_482 asemeType
highlight default link asemeType_484 asemeType
highlight default link asemeType_501 asemeType
highlight default link asemeType_552 asemeType
highlight default link asemeType_560 asemeType
highlight default link asemeType_58 asemeType
highlight default link asemeType_63 asemeType
highlight default link asemeType_684 asemeType
highlight default link asemeType_689 asemeType
highlight default link asemeType_69 asemeType
highlight default link asemeType_695 asemeType
highlight default link asemeType_697 asemeType
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
