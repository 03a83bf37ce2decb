" The groups of the syntax file at places of files, for colours_test.py.
"
"   vim -es -u NONE -i NONE --cmd 'let g:asked = …' --cmd 'let g:answer = …' -S groups.vim
"
" The file asked has a line of JSON for each model: its path, and its places, each with its line and the byte in it, from 1.
" The answer has a line of JSON for each: the group at each place.

set nocompatible encoding=utf-8 nomodeline hidden
exe 'set runtimepath^=' . fnameescape(g:plugin)
filetype plugin on
syntax on
set synmaxcol=0 redrawtime=100000

let s:answers = []
for s:line in readfile(g:asked)
  let s:asked = json_decode(s:line)
  exe 'edit' fnameescape(s:asked.path)
  if &filetype !=# 'scc'
    call add(s:answers, json_encode(['not the type scc: ' . &filetype]))
    continue
  endif
  call add(s:answers, json_encode(map(copy(s:asked.places), {_, at -> synIDattr(synID(at[0], at[1], 1), 'name')})))
  bwipeout!
endfor
call writefile(s:answers, g:answer)
qall!
