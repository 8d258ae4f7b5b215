" What Vim should know of ASEME besides colours.
if exists("b:did_ftplugin")
  finish
endif
let b:did_ftplugin = 1

setlocal comments=s1:/*,mb:*,ex:*/,:// commentstring=//\ %s
setlocal formatoptions-=t formatoptions+=croql
setlocal expandtab shiftwidth=2 softtabstop=2
setlocal suffixesadd=.aseme

" `:make` checks the file, and the quickfix list has the mistakes.
setlocal makeprg=asemec\ check\ %:S
setlocal errorformat=%f:%l:%c:\ %trror[%*[^]]]:\ %m,%f:%l:%c:\ %tarning[%*[^]]]:\ %m,%f:%l:%c:\ %tote[%*[^]]]:\ %m,%-G%.%#

if executable("asemec")
  setlocal formatprg=asemec\ fmt\ -
endif

let b:undo_ftplugin = "setlocal comments< commentstring< formatoptions< expandtab< shiftwidth<"
      \ . " softtabstop< suffixesadd< makeprg< errorformat< formatprg<"
