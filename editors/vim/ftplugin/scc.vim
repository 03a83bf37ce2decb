" Models of scc.

if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=//\ %s comments=sr:/*,mb:*,ex:*/,:// expandtab shiftwidth=2 softtabstop=2 iskeyword+='
" `:make` checks the model, and its messages become the list of errors.
setlocal makeprg=scc\ check\ %:S
setlocal errorformat=%f:%l:%c:\ %trror[SC%n]:\ %m,%f:%l:%c:\ %tarning[SC%n]:\ %m,%-G%.%#

let b:undo_ftplugin = 'setlocal commentstring< comments< expandtab< shiftwidth< softtabstop< iskeyword< makeprg< errorformat<'
