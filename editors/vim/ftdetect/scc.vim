" Vim takes *.sc for Scala or SuperCollider. What declares something as models do is a model, and so is a new file.
function! s:Detect() abort
  let l:words = 'model|import|param|let|shape|compound|behaviour|process|fixed|bond|for|network|motion|check|timestep'
        \ . '|split_step|dynamics|collisions|binding|bonds|blocked|resolution|round'
  if match(getline(1, 200), '\v^\s*(' . l:words . ')>\s*[A-Za-z0-9"<(]') >= 0
    " Not every plugin for a type can be undone, and one that cannot would keep ours away.
    unlet! b:did_ftplugin
    set filetype=scc
  endif
endfunction

au BufRead *.sc call s:Detect()
au BufNewFile *.sc set filetype=scc
