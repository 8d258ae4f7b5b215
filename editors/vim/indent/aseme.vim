" Indentation of ASEME: by braces, and a step more for what a line leaves open.
if exists("b:did_indent")
  finish
endif
let b:did_indent = 1

setlocal indentexpr=AsemeIndent() indentkeys=0},0),0],!^F,o,O nosmartindent
let b:undo_indent = "setlocal indentexpr< indentkeys< smartindent<"

if exists("*AsemeIndent")
  finish
endif

" How many braces a line opens and does not close; those in texts and comments do not count.
function s:Opened(line) abort
  let text = substitute(a:line, '"\%([^"\\]\|\\.\)*"', '', 'g')
  let text = substitute(text, '//.*$', '', '')
  let text = substitute(text, '/\*.\{-}\*/', '', 'g')
  let text = substitute(text, '^[})\]]\+', '', '')
  return count(text, '{') + count(text, '(') + count(text, '[')
        \ - count(text, '}') - count(text, ')') - count(text, ']')
endfunction

function AsemeIndent() abort
  let above = prevnonblank(v:lnum - 1)
  if above == 0
    return 0
  endif
  let found = indent(above) + shiftwidth() * s:Opened(trim(getline(above)))
  if getline(v:lnum) =~# '^\s*[})\]]'
    let found -= shiftwidth()
  endif
  return max([found, 0])
endfunction
