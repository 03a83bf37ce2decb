" The modelling language of scc. editors/words writes the lists of words.

if exists('b:current_syntax')
  finish
endif

syn case match
" Letters, digits, `_` and `'` make a name.
syn iskeyword @,48-57,_,'

syn match sccName "\<[A-Za-z][A-Za-z0-9_']*\>"
syn match sccNumber "\<\d\+\(\.\d\+\)\=\([eE][+-]\=\d\+\)\=\>"
syn match sccNumber "\<2^-\d\+"
syn match sccOperator "[-=<>!+*/~|?]"
syn match sccOperator "\.\."
syn match sccOperator "[⟨〈〈⟩〉〉‖∥·⋅]"
syn match sccKeyword "[ωρϱεϵ]"

" sccKeyword: words: keyword setting
syn keyword sccKeyword absorb as at behaviour bond check choose compound decompose eps faces fixed for glue grid
syn keyword sccKeyword hull import in inertial let mass matrix merge mesh model motion network omega on only
syn keyword sccKeyword orient param part process push quaternion rho rotate scale scaled shape snap spin
syn keyword sccKeyword translate union velocity vertices weight weld where binding blocked bonds collisions
syn keyword sccKeyword dynamics local resolution round split_step steady timestep
" words: end
" sccWord: words: operator temporal
syn keyword sccWord and count else exists forall if mod not or then AF AG AX EF EG EX always event eventually
syn keyword sccWord leads_to possibly within
" words: end
" sccConstant: words: literal
syn keyword sccConstant false nil true
" words: end
" sccFunction: words: function solid
syn keyword sccFunction abs ceil cross diffuse dot floor max min sign antiprism box prism pyramid
" words: end
" sccAtom: words: atom
syn keyword sccAtom angular bound distance2 dt energy gone momentum offers processes quiescent same size
syn keyword sccAtom speed2 spin2 time touching vx vy vz wx wy wz x y z
" words: end

" Letters are words only where an operator stands.
syn match sccWord "\<[AE]\ze\s*\["
syn match sccWord "\%(\s\|[)\]]\)\@<=U\>\ze\s*[[(A-Za-z0-9-]"
" What probabilities and means are called.
syn match sccFunction "\<\(P\|Pmin\|Pmax\|E\|Emin\|Emax\)\ze\s*[<>=]"
" A name where it is declared.
syn match sccDeclared "\%(\<\%(shape\|compound\|behaviour\|process\|fixed\|part\|param\|let\|check\|model\)\s\+\)\@<=[A-Za-z][A-Za-z0-9_']*"
" The name of a channel, whatever word it is.
syn match sccChannel "\%([<⟨]\s*\~\=\|\~\)\@<=[A-Za-z][A-Za-z0-9_']*\ze\s*,\s*{"

syn region sccComment start="//" end="$" keepend contains=@Spell
syn region sccComment start="/\*" end="\*/" contains=sccComment,@Spell
syn region sccString start=+"+ skip=+\\.+ end=+"+ oneline
syn region sccBlock start="{" end="}" transparent fold
syn sync fromstart

hi def link sccName NONE
hi def link sccNumber Number
hi def link sccOperator Operator
hi def link sccKeyword Keyword
hi def link sccWord Conditional
hi def link sccConstant Constant
hi def link sccFunction Function
hi def link sccAtom Identifier
hi def link sccDeclared Type
hi def link sccChannel Tag
hi def link sccComment Comment
hi def link sccString String

let b:current_syntax = 'scc'
