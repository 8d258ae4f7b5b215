autocmd BufRead,BufNewFile *.aseme setfiletype aseme
