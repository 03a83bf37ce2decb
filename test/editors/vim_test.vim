" Models in Vim: the type of files, `:make` with its list of errors, folds, and comments.
"
"   vim -es -u NONE -i NONE --cmd 'let g:plugin = …' --cmd 'let g:scc = …' --cmd 'let g:work = …' -S vim_test.vim
"
" g:plugin is editors/vim, g:scc the program, g:work an empty folder. The file answer there has what failed, and last a line
" 'N passed, N failed'.

set nocompatible encoding=utf-8 noswapfile hidden
exe 'set runtimepath^=' . fnameescape(g:plugin)
filetype plugin on
syntax on

let s:lines = []
let s:counts = [0, 0]

function! s:Expect(what, wanted, got)
  let s:counts[a:wanted !=# a:got] += 1
  if a:wanted !=# a:got
    call add(s:lines, a:what . ': ' . string(a:got) . ', not ' . string(a:wanted))
  endif
endfunction

function! s:Write(name, lines)
  call writefile(a:lines, g:work . '/' . a:name)
  exe 'edit!' fnameescape(g:work . '/' . a:name)
endfunction

call s:Write('scala.sc', ['class A { val x = 1 }'])
call s:Expect('a worksheet of Scala', 0, &filetype ==# 'scc')
call s:Write('new folder.sc', ['// a model', 'process p = box(1, 1, 1) mass 1 [Gone]', 'check a : possibly x(p) > 1 // b'])
call s:Expect('a model', 'scc', &filetype)
let $PATH = g:work . '/bin:' . $PATH
call mkdir(g:work . '/bin')
call system('ln -s ' . shellescape(g:scc) . ' ' . shellescape(g:work . '/bin/scc'))
silent! make!
let s:errors = filter(getqflist(), 'v:val.valid')
call s:Expect('errors of :make', 1, len(s:errors))
call s:Expect('their places', [2, 34, 'E', 201], [s:errors[0].lnum, s:errors[0].col, toupper(s:errors[0].type), s:errors[0].nr])
call s:Expect('their file', bufnr('%'), s:errors[0].bufnr)
call s:Expect('comments', '// %s', &commentstring)
call s:Write('nested.sc', ['model nested', '/* a /* b */ c */ process p = box(1, 1, 1) mass 1 [nil]'])
call s:Expect('comments nest', ['sccComment', 'sccKeyword'],
      \ [synIDattr(synID(2, 14, 1), 'name'), synIDattr(synID(2, 19, 1), 'name')])
set foldmethod=syntax foldlevel=0
call s:Write('fold.sc', ['shape S {', '  vertices a (0,0,0)', '  faces', '}', 'process p = S mass 1 [nil]'])
call s:Expect('folds', [1, 4, -1], [foldclosed(2), foldclosedend(2), foldclosed(5)])

call writefile(add(s:lines, s:counts[0] . ' passed, ' . s:counts[1] . ' failed'), g:work . '/answer')
qall!
