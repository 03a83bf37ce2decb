(* The grammar of the modelling language; specs/language.md is its reference.
   Every state in which a token can be refused has its own sentence in parser.messages: the build compares
   the two, so a change here means a change there. *)

%{
  open Ast

  let span ((first, last) : Lexing.position * Lexing.position) =
    Scc_base.Span.make ~file:first.pos_fname ~start:first.pos_cnum ~stop:last.pos_cnum

  let at loc it = { it; at = span loc }

  (* A chain of leaves while it is read: the first leaf, and the rest in reverse. Brackets of the text are
     flattened here ([I-5]), each leaf moved once per pair of brackets. *)
  type chain = { head : leaf; tail : (bond * leaf) list }

  let join left bond right = { left with tail = right.tail @ ((bond, right.head) :: left.tail) }
%}

%start <Ast.model> model
%start <Ast.expr> expression

(* On an error, finish what can be finished: fewer states, and a message about the larger thing *)
%on_error_reduce expr arithmetic plain_path segment term_segment behaviour behaviour_term solid
  indexed(name) indexed(member_name)
  chain(moving) chain(still) leaf(moving) leaf(still) moving still body
  reversed(attribute) reversed(transform_factor)
  reversed(item) reversed(vertex) reversed(face) reversed(part) reversed(glue) reversed(parallel) transforms
  path term_path feature(name) feature(member_name) name member_name term_name plain_name common_name

%%

model: items = many(item) EOF { items }

expression: e = expr EOF { e }

(* Lists, left recursive: the stack stays flat *)

reversed(X):
| { [] }
| xs = reversed(X) x = X { x :: xs }

%inline many(X): xs = reversed(X) { List.rev xs }

comma_separated(X):
| x = X { [ x ] }
| xs = comma_separated(X) COMMA x = X { x :: xs }

%inline comma_list(X): xs = comma_separated(X) { List.rev xs }

%inline optional_list(X):
| { [] }
| xs = comma_list(X) { xs }

(* Names and paths *)

(* A letter of the temporal operators is a name wherever it cannot be one of them, and `only` where it cannot be the
   word before a feature. *)

common_name:
| n = NAME { at $loc n }
| n = LETTER { at $loc n }
| U { at $loc "U" }
| BOND { at $loc "bond" }
| MASS { at $loc "mass" }
| EVENT { at $loc "event" }
| DYNAMICS { at $loc "dynamics" }
| COLLISIONS { at $loc "collisions" }
| BINDING { at $loc "binding" }
| SNAP { at $loc "snap" }
| RESOLUTION { at $loc "resolution" }
| ROUND { at $loc "round" }
| STEADY { at $loc "steady" }

plain_name:
| n = common_name { n }
| ONLY { at $loc "only" }

%inline quantifying_letter:
| A { at $loc "A" }
| E { at $loc "E" }

%inline operator_word:
| AF { at $loc "AF" }
| AG { at $loc "AG" }
| AX { at $loc "AX" }
| EF { at $loc "EF" }
| EG { at $loc "EG" }
| EX { at $loc "EX" }

(* Where an expression may stand: `A[` is followed by indices or by `f U g]`, which the bracket after tells. *)
term_name: n = plain_name | n = quantifying_letter { n }

name: n = term_name | n = operator_word { n }

member_name: n = common_name | n = quantifying_letter | n = operator_word { n }

indexed(N):
| name = N { { name; indices = [] } }
| name = N LBRACKET indices = comma_list(expr) RBRACKET { { name; indices } }

segment: s = indexed(name) { s }

term_segment:
| name = term_name { { name; indices = [] } }
| name = plain_name LBRACKET indices = comma_list(expr) RBRACKET { { name; indices } }
| name = quantifying_letter LBRACKET indices = comma_list(expr) RBRACKET { { name; indices } }

segments(N):
| s = indexed(N) { [ s ] }
| ss = segments(N) DOT s = segment { s :: ss }

path: ss = segments(name) { at $loc (List.rev ss) }

term_segments:
| s = term_segment { [ s ] }
| ss = term_segments DOT s = segment { s :: ss }

term_path: ss = term_segments { at $loc (List.rev ss) }

polar_name:
| n = name { (false, n) }
| TILDE n = name { (true, n) }
| n = BARRED { (true, at $loc n) }

vector: LPAREN x = expr COMMA y = expr COMMA z = expr RPAREN { (x, y, z) }
quadruple: LPAREN w = expr COMMA x = expr COMMA y = expr COMMA z = expr RPAREN { (w, x, y, z) }

(* Features, channels and bonds *)

feature(N):
| ss = segments(N) { at $loc (Named (at $loc (List.rev ss))) }
| ss = segments(N) DOT vs = vertex_tuple { at $loc (Tuple (Some (at $loc(ss) (List.rev ss)), vs)) }
| vs = vertex_tuple { at $loc (Tuple (None, vs)) }

vertex_tuple: LBRACKET vs = comma_list(path) RBRACKET { vs }

member:
| f = feature(member_name) { { feature = f; only = false } }
| ONLY f = feature(name) { { feature = f; only = true } }

features: LBRACE fs = optional_list(member) RBRACE { fs }

angle_channel:
| LT c = polar_name COMMA features = features GT
    { { co = fst c; channel = snd c; features; span = span $loc } }

weak_channel:
| OMEGA LPAREN c = polar_name COMMA features = features RPAREN
    { { co = fst c; channel = snd c; features; span = span $loc } }

bond:
| LT bond = name COMMA LBRACE first = feature(name) COMMA second = feature(name) RBRACE GT
    { { bond; first; second; bond_span = span $loc } }

(* Behaviours *)

behaviour:
| b = behaviour_term { b }
| b = behaviour PLUS c = behaviour_term { at $loc (Sum (b, c)) }

behaviour_term:
| NIL { at $loc Nil }
| k = name { at $loc (Name k) }
| LPAREN b = behaviour RPAREN { b }
| c = angle_channel DOT b = behaviour_term { at $loc (Open (c, b)) }
| c = weak_channel DOT b = behaviour_term { at $loc (Weak (c, b)) }
| RHO LPAREN LBRACE cs = optional_list(angle_channel) RBRACE RPAREN DOT b = behaviour_term
    { at $loc (Strong (cs, b)) }
| EPS LPAREN t = expr RPAREN DOT b = behaviour_term { at $loc (Delay (t, b)) }

(* Shapes and where they are *)

solid:
| n = name { at $loc (Template n) }
| MESH file = STRING d = snap? { at $loc (Mesh (at $loc(file) file, d)) }
| s = solid SCALED v = vector { at $loc (Scaled (s, v)) }

snap: SNAP e = arithmetic { e }

vertex: n = name v = vector { (n, v) }
face: n = name LBRACKET vs = comma_list(name) RBRACKET { (n, vs) }

template:
| VERTICES vs = many(vertex) FACES fs = many(face) { Faces (vs, fs) }

transform:
| TRANSLATE v = vector { at $loc (Translate v) }
| ROTATE QUATERNION q = quadruple { let w, x, y, z = q in at $loc (Rotate (w, x, y, z)) }
| SCALE v = vector { at $loc (Scale v) }
| MATRIX LPAREN a = quadruple COMMA b = quadruple COMMA c = quadruple COMMA d = quadruple RPAREN
    { at $loc (Matrix [ a; b; c; d ]) }

transform_factor: STAR t = transform { t }
transforms: t = transform ts = many(transform_factor) { t :: ts }

attribute:
| MASS e = arithmetic { at $loc (Mass e) }
| VELOCITY v = vector { at $loc (Velocity v) }
| SPIN v = vector { at $loc (Spin v) }
| AT ts = transforms { at $loc (At ts) }

part:
| PART part = name COLON part_solid = solid part_attributes = many(attribute)
    { { part; part_solid; part_attributes; part_span = span $loc } }

glue:
| GLUE glue_first = feature(name) TILDE glue_second = feature(name)
    { { glue_first; glue_second; glue_span = span $loc } }

(* Processes: [labelled] and [unlabelled] are told apart by the colon, [moving] and [still] by whether the
   behaviour may be left out *)

label:
| name = name COLON { { name; indices = [] } }
| name = name LABEL_BRACKET indices = comma_list(expr) RBRACKET COLON { { name; indices } }

body:
| solid = solid attributes = many(attribute) { (solid, attributes) }

behaviour_box: LBRACKET b = behaviour RBRACKET { b }

moving:
| label = ioption(label) body = body b = behaviour_box
    { { label; solid = fst body; attributes = snd body; behaviour = Some b; leaf_span = span $sloc } }

still:
| label = ioption(label) body = body b = ioption(behaviour_box)
    { { label; solid = fst body; attributes = snd body; behaviour = b; leaf_span = span $sloc } }

leaf(X):
| l = X { { head = l; tail = [] } }
| LPAREN c = chain(X) RPAREN { c }

chain(X):
| c = leaf(X) { c }
| c = chain(X) b = bond d = leaf(X) { join c b d }

(* Laws of motion *)

law:
| INERTIAL { at $loc Inertial }
| v = vector { at $loc (Expression v) }
| CHOOSE LBRACE kicks = comma_list(kick) RBRACE { at $loc (Choose kicks) }

kick:
| v = vector { (v, None) }
| v = vector WEIGHT w = expr { (v, Some w) }

(* Items *)

range: i = name IN low = expr DOTDOT high = expr { (i, low, high) }
parallel: PARALLEL p = path { p }

%inline pace:
| { Shared }
| LOCAL { Local }
| STEADY { Steady }

item: i = item_kind { at $loc i }

item_kind:
| MODEL n = name { Model n }
| PARAM n = name EQ e = expr { Param (n, e) }
| TIMESTEP e = expr p = pace { Timestep (e, p) }
| SPLIT_STEP e = expr { Split_step e }
| DYNAMICS d = NAME { Dynamics (at $loc(d) d) }
| COLLISIONS c = NAME { Collisions (at $loc(c) c) }
| BINDING b = NAME { Binding (at $loc(b) b) }
| RESOLUTION e = expr { Resolution e }
| ROUND n = NAME e = expr { Round (at $loc(n) n, e) }
| ROUND VELOCITY e = expr { Round (at $loc($2) "velocity", e) }
| SHAPE n = name EQ s = solid { Shape (n, s) }
| SHAPE n = name LBRACE t = template RBRACE { Shape (n, at $loc(t) t) }
| COMPOUND n = name LBRACE parts = many(part) glues = many(glue) RBRACE { Compound (n, parts, glues) }
| BEHAVIOUR n = name EQ b = behaviour { Behaviour (n, None, b) }
| BEHAVIOUR n = name ON t = name EQ b = behaviour { Behaviour (n, Some t, b) }
| PROCESS s = segment EQ c = chain(moving) { Process (s, c.head, List.rev c.tail) }
| FIXED s = segment EQ c = chain(still) { Fixed (s, c.head, List.rev c.tail) }
| BOND b = bond { Bond b }
| FOR ranges = comma_list(range) LBRACE body = many(item) RBRACE { For (ranges, body) }
| NETWORK NIL { Network [] }
| NETWORK p = path ps = many(parallel) { Network (p :: ps) }
| MOTION l = law { Motion (None, l) }
| MOTION p = path EQ l = law { Motion (Some p, l) }
| LET n = name EQ e = expr { Let (n, e) }
| CHECK n = name COLON e = expr { Check (n, e) }

(* Numbers, truth values and formulas *)

%inline arithmetic_operator:
| PLUS { Add }
| MINUS { Sub }
| STAR { Mul }
| SLASH { Div }

%inline operator:
| o = arithmetic_operator { o }
| LT { Lt }
| LE { Le }
| GT { Gt }
| GE { Ge }
| EQ { Eq }
| NE { Ne }
| AND { And }
| OR { Or }
| IMPLIES { Implies }

%inline english:
| POSSIBLY { Possibly }
| ALWAYS { Always }
| EVENTUALLY { Eventually }

%inline letters:
| AF { Finally Ast.A }
| EF { Finally Ast.E }
| AG { Globally Ast.A }
| EG { Globally Ast.E }

%inline next:
| AX { Next Ast.A }
| EX { Next Ast.E }

%inline path_quantifier:
| A { Ast.A }
| E { Ast.E }

%inline quantifier:
| FORALL { Forall }
| EXISTS { Exists }

bound:
| LBRACKET LE t = expr RBRACKET { At_most t }
| LBRACKET a = expr COMMA b = expr RBRACKET { Between (a, b) }

expr:
| q = NUMBER { at $loc (Number q) }
| TRUE { at $loc True }
| FALSE { at $loc False }
| p = term_path { at $loc (Path p) }
| TILDE n = name { at $loc (Co n) }
| n = BARRED { at $loc (Co (at $loc n)) }
| f = term_name LPAREN es = optional_list(expr) RPAREN { at $loc (Apply (f, es)) }
| BEHAVIOUR LPAREN es = optional_list(expr) RPAREN { at $loc (Apply (at $loc($1) "behaviour", es)) }
| LPAREN e = expr RPAREN { e }
| COUNT LPAREN p = name IN t = name COLON e = expr RPAREN { at $loc (Quantified (Count, p, t, e)) }
| EVENT e = NAME { at $loc (Event (at $loc(e) e, [])) }
| EVENT e = NAME LPAREN es = optional_list(expr) RPAREN { at $loc (Event (at $loc(e) e, es)) }
| q = path_quantifier LBRACKET f = expr U b = ioption(bound) g = expr RBRACKET
    { at $loc (Until (q, f, b, g)) }
| MINUS e = expr %prec NEGATION { at $loc (Neg e) }
| NOT e = expr { at $loc (Not e) }
| l = expr o = operator r = expr { at $loc (Binary (o, l, r)) }
| f = expr LEADS_TO b = ioption(bound) g = expr %prec LEADS_TO { at $loc (Leads_to (f, b, g)) }
| f = expr LEADS_TO g = expr WITHIN d = expr %prec WITHIN_ARGUMENT
    { at $loc (Leads_to (f, Some (Within d), g)) }
| IF c = expr THEN t = expr ELSE e = expr %prec OPEN { at $loc (If (c, t, e)) }
| q = quantifier p = name IN t = name COLON e = expr %prec OPEN { at $loc (Quantified (q, p, t, e)) }
| t = english b = ioption(bound) e = expr %prec OPEN { at $loc (Temporal (t, b, e)) }
| t = english e = expr WITHIN d = expr %prec WITHIN_ARGUMENT { at $loc (Temporal (t, Some (Within d), e)) }
| t = letters b = ioption(bound) e = expr %prec NOT { at $loc (Temporal (t, b, e)) }
| t = next e = expr %prec NOT { at $loc (Temporal (t, None, e)) }

(* Attributes: arithmetic alone, and no index outside brackets, so that `<` after one opens a bond and `[` a
   behaviour *)

plain_path:
| n = name { [ { name = n; indices = [] } ] }
| ss = plain_path DOT n = name { { name = n; indices = [] } :: ss }

arithmetic:
| q = NUMBER { at $loc (Number q) }
| ss = plain_path { at $loc (Path (at $loc (List.rev ss))) }
| f = name LPAREN es = optional_list(expr) RPAREN { at $loc (Apply (f, es)) }
| LPAREN e = expr RPAREN { e }
| MINUS e = arithmetic %prec NEGATION { at $loc (Neg e) }
| l = arithmetic o = arithmetic_operator r = arithmetic { at $loc (Binary (o, l, r)) }
