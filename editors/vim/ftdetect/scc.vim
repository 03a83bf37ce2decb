au BufRead,BufNewFile *.sc setfiletype scc
