" Indentation of ASEME: a step for each open brace. Lines that are continued keep what they are aligned with.
if exists("b:did_indent")
  finish
endif
let b:did_indent = 1

setlocal indentexpr=AsemeIndent() indentkeys=0},0),0],!^F,o,O nosmartindent
let b:undo_indent = "setlocal indentexpr< indentkeys< smartindent<"

if exists("*AsemeIndent")
  finish
endif

" The code of a line, and whether a block comment goes on after it; texts and comments are taken out.
function s:Code(line, comment) abort
  let [text, comment] = [a:line, a:comment]
  let code = ""
  while text !=# ""
    if comment
      let end = stridx(text, "*/")
      if end < 0
        return [code, 1]
      endif
      let [text, comment] = [text[end + 2 :], 0]
      continue
    endif
    let place = match(text, '["/]')
    if place < 0
      return [code . text, 0]
    endif
    let [code, text] = [code . strpart(text, 0, place), strpart(text, place)]
    if text[0:1] ==# "//"
      return [code, 0]
    elseif text[0:1] ==# "/*"
      let [text, comment] = [text[2:], 1]
    elseif text[0] ==# '"'
      let text = substitute(text, '^"\%([^"\\]\|\\.\)*"\?', '', '')
    else
      let [code, text] = [code . text[0], text[1:]]
    endif
  endwhile
  return [code, comment]
endfunction

function AsemeIndent() abort
  " A line above that begins in the first column has nothing open before it.
  let above = v:lnum - 1
  while above > 1 && getline(above) !~# '^\h'
    let above -= 1
  endwhile
  let [depth, comment, last] = [0, 0, ""]
  for number in range(max([above, 1]), v:lnum - 1)
    let [code, comment] = s:Code(getline(number), comment)
    let depth += count(code, "{") - count(code, "}")
    let last = code =~# '\S' ? code : last
  endfor
  let line = getline(v:lnum)
  if comment
    return -1
  endif
  let found = shiftwidth() * max([depth - (line =~# '^\s*}' ? 1 : 0), 0])
  let begins = line =~# '^\s*}' || last ==# "" || last =~# '[{}]\s*$'
        \ || (line =~# '^\s*\h\w*\s*=[^=]' && last !~# '[;,/]\s*$')
  return line =~# '\S' && !begins && indent(v:lnum) > found ? indent(v:lnum) : found
endfunction
