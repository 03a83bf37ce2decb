; What is coloured how. The last pattern that matches a node counts in Neovim, the first one elsewhere: no two of these
; match one node unless they agree.

; Comments, numbers, texts
(line_comment) @comment
(block_comment) @comment
(number) @number
(string) @string
(boolean) @boolean
(nil) @constant.builtin

; Declarations
["model" "param" "let" "check" "where" "shape" "compound" "part" "glue" "behaviour" "on" "process" "fixed" "bond"
 "network" "motion" "timestep" "local" "steady" "split_step" "dynamics" "collisions" "binding" "bonds" "blocked"
 "resolution" "round" "vertices" "faces" "hull" "mesh" "grid" "weld" "orient" "merge" "snap" "union" "decompose"
 "scaled" "mass" "velocity" "spin" "at" "translate" "rotate" "quaternion" "scale" "matrix" "only" "push" "choose"
 "weight" "event" "count"] @keyword
(absorb) @keyword
(inertial) @keyword
["import" "as"] @keyword.import
["for" "in"] @keyword.repeat
["if" "then" "else"] @keyword.conditional
["omega" "rho" "eps"] @keyword.function
(odds kind: (name) @keyword)

; Operators, in words and as marks
["and" "or" "not" "mod" "forall" "exists"] @keyword.operator
["possibly" "always" "eventually" "within" "leads_to" "AF" "AG" "AX" "EF" "EG" "EX" "A" "E" "U"] @keyword.operator
["=" "!=" "<=" ">=" "=>" "+" "-" "*" "/" "~" "||" "?" "<" ">"] @operator
["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ":" "." ".."] @punctuation.delimiter

; Names, where they are declared
(model_declaration name: (name) @module)
(param_declaration name: (name) @constant)
(let_declaration name: (name) @constant)
(definition name: (name) @constant)
(check_declaration name: (name) @label)
(shape_declaration name: (name) @type)
(compound_declaration name: (name) @type)
(behaviour_declaration name: (name) @function)
(process_declaration name: (name) @variable)
(fixed_declaration name: (name) @variable)
(part name: (name) @variable)
(label name: (name) @variable)
(range name: (name) @variable.parameter)
(quantified name: (name) @variable.parameter)
(count name: (name) @variable.parameter)
(parameters (name) @variable.parameter)
(vertex name: (name) @property)
(face name: (name) @property)

; Names, where they are used
(template_name module: (name) @module)
(template_name !module (name) @type)
(behaviour_name module: (name) @module)
(behaviour_name !module (name) @function)
(channel name: (name) @constructor)
(channel name: (barred_name) @constructor)
(weak_channel name: (name) @constructor)
(weak_channel name: (barred_name) @constructor)
(bond name: (name) @constructor)
(co_name) @constructor
(feature (name) @property)
(component axis: (name) @property)
(setting_declaration value: (name) @constant.builtin)
(event kind: (name) @function.builtin)
((call function: (name) @function.builtin)
 (#any-of? @function.builtin
  ; words: function
  "abs" "ceil" "cross" "diffuse" "dot" "floor" "max" "min" "sign"
  ; words: end
 ))
((call function: (name) @function.builtin)
 (#any-of? @function.builtin
  ; words: atom
  "angular" "bound" "distance2" "dt" "energy" "gone" "momentum" "offers" "processes" "quiescent" "same" "size"
  "speed2" "spin2" "time" "touching" "vx" "vy" "vz" "wx" "wy" "wz" "x" "y" "z"
  ; words: end
 ))
((template_name !module (name) @type.builtin)
 (#any-of? @type.builtin
  ; words: solid
  "antiprism" "box" "prism" "pyramid"
  ; words: end
 ))
((path . (name) @variable.builtin .)
 (#any-of? @variable.builtin
  ; words: atom
  "angular" "bound" "distance2" "dt" "energy" "gone" "momentum" "offers" "processes" "quiescent" "same" "size"
  "speed2" "spin2" "time" "touching" "vx" "vy" "vz" "wx" "wy" "wz" "x" "y" "z"
  ; words: end
 ))
((path . (name) @keyword.operator .)
 (#any-of? @keyword.operator
  ; words: measure
  "Emax" "Emin" "P" "Pmax" "Pmin"
  ; words: end
 ))
