(* The grammar of the modelling language; specs/language.md is its reference, expressions.mly its other part.
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
%on_error_reduce expr arithmetic plain_path segment term_segment later_segment behaviour behaviour_term solid
  indexed(name) indexed(member_name)
  chain(moving) chain(still) leaf(moving) leaf(still) moving still body
  reversed(attribute) reversed(transform_factor)
  reversed(item) reversed(vertex) reversed(face) reversed(part) reversed(glue) reversed(parallel) transforms
  path term_path feature(name) feature(member_name) name member_name term_name plain_name common_name reference vector closed_vector head behaviour_head

%%

model: items = many(item) EOF { items }

expression: e = expr EOF { e }

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

(* What a module declares: after the name of a solid, `[` opens a behaviour *)

%inline qualified:
| n = name { (None, n) }
| q = name DOT n = name { (Some q, n) }

reference:
| n = qualified { { qualifier = fst n; target = snd n; indices = []; arguments = [] } }
| n = qualified LPAREN arguments = comma_list(expr) RPAREN
    { { qualifier = fst n; target = snd n; indices = []; arguments } }

indexed_reference:
| n = qualified LBRACKET indices = comma_list(expr) RBRACKET
    { { qualifier = fst n; target = snd n; indices; arguments = [] } }

head:
| declared = name { { declared; places = []; formals = [] } }
| declared = name LPAREN formals = comma_list(name) RPAREN { { declared; places = []; formals } }

places: declared = name LBRACKET places = comma_list(expr) RBRACKET { { declared; places; formals = [] } }

definition: n = name EQ e = expr { (n, e) }

definitions:
| { [] }
| WHERE ds = comma_list(definition) { ds }

(* Behaviours *)

push: PUSH LPAREN j = expr RPAREN { j }

(* What a dot can follow: in an expression a name and a dot might go on. *)
odds_value:
| q = NUMBER { at $loc (Number q) }
| p = NUMBER SLASH q = NUMBER { at $loc (Binary (Div, at $loc(p) (Number p), at $loc(q) (Number q))) }
| n = name { at $loc (Path (at $loc [ { name = n; indices = [] } ])) }
| LPAREN e = expr RPAREN { e }

odds: w = NAME e = odds_value { { odds = at $loc(w) w; value = e } }

behaviour:
| b = behaviour_term { b }
| b = behaviour PLUS c = behaviour_term { at $loc (Sum (b, c)) }

behaviour_term:
| NIL { at $loc Nil }
| k = reference { at $loc (Name k) }
| k = indexed_reference { at $loc (Name k) }
| LPAREN b = behaviour RPAREN { b }
| c = angle_channel DOT b = behaviour_term { at $loc (Open (c, b)) }
| c = weak_channel push = ioption(push) odds = ioption(odds) DOT b = behaviour_term
    { at $loc (Weak (c, { push; odds }, b)) }
| RHO LPAREN LBRACE cs = optional_list(angle_channel) RBRACE RPAREN j = ioption(push) DOT b = behaviour_term
    { at $loc (Strong (cs, j, b)) }
| EPS LPAREN t = expr RPAREN DOT b = behaviour_term { at $loc (Delay (t, b)) }

(* Shapes and where they are *)

solid:
| t = reference { at $loc (Template t) }
| HULL LBRACE points = many(vertex) RBRACE { at $loc (Hull points) }
| MESH file = STRING m = mending { at $loc (Mesh (at $loc(file) file, m)) }
| s = solid SCALED v = vector { at $loc (Scaled (s, v)) }

grid: GRID e = arithmetic { e }
snap: SNAP e = arithmetic { e }
mending:
| grid = grid? weld = boption(WELD) orient = boption(ORIENT) merge = boption(MERGE) snap = snap?
    union = boption(UNION)
    { { grid; weld; orient; merge; snap; union } }

vertex: n = name v = closed_vector { (n, v) }
face: n = name LBRACKET vs = comma_list(name) RBRACKET { (n, vs) }

template:
| VERTICES vs = many(vertex) FACES fs = many(face) { Faces (vs, fs) }

decomposed:
| file = STRING m = mending { at $loc (Mesh (at $loc(file) file, m)) }
| LBRACE t = template RBRACE { at $loc t }
| s = decomposed SCALED v = vector { at $loc (Scaled (s, v)) }

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
| VELOCITY v = arithmetic { at $loc (Velocity v) }
| SPIN v = arithmetic { at $loc (Spin v) }
| ABSORB { at $loc Absorb }
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

named_law:
| INERTIAL { at $loc Inertial }
| CHOOSE LBRACE kicks = comma_list(kick) RBRACE { at $loc (Choose kicks) }

law:
| l = named_law { l }
| v = expr s = ioption(spinning) { at $loc (Expression (v, s)) }

(* Without the name of a body, which would be taken for the beginning of an expression. *)
law_of_all:
| l = named_law { l }
| v = standing s = ioption(spinning) { at $loc (Expression (v, s)) }

standing:
| v = closed_vector { v }
| c = call(name) { c }
| IF c = expr THEN t = expr ELSE e = expr { at $loc (If (c, t, e)) }

kick:
| velocity = expr spin = ioption(spinning) weight = ioption(weight) { { over = []; velocity; spin; weight } }
| FOR over = comma_list(range) COLON velocity = expr spin = ioption(spinning) weight = ioption(weight)
    { { over; velocity; spin; weight } }

spinning: SPIN w = expr { w }

weight: WEIGHT w = expr { w }

(* Items *)

range: index = name IN bounds = bounds { { index; bounds } }

lower:
| LBRACKET value = expr { { value; included = true } }
| LPAREN value = expr { { value; included = false } }

upper:
| value = expr RBRACKET { { value; included = true } }
| value = expr RPAREN { { value; included = false } }

chosen:
| n = name { (n, None) }
| n = name AS m = name { (n, Some m) }

imported:
| { Qualified None }
| AS n = name { Qualified (Some n) }
| LPAREN ns = comma_list(chosen) RPAREN { Chosen ns }

import:
| IMPORT from = STRING names = imported { { from = at $loc(from) from; library = false; names } }
| IMPORT LT from = name GT names = imported { { from; library = true; names } }

behaviour_head:
| h = head { h }
| h = places { h }

parallel: PARALLEL p = path { p }

%inline pace:
| { Shared }
| LOCAL { Local }
| STEADY { Steady }

item: i = item_kind { at $loc i }

item_kind:
| MODEL n = name { Model n }
| PARAM n = name EQ e = expr { Param (n, e) }
| PARAM n = name IN low = lower COMMA high = upper { Param_in (n, low, high) }
| TIMESTEP e = expr p = pace { Timestep (e, p) }
| SPLIT_STEP e = expr { Split_step e }
| DYNAMICS d = NAME { Dynamics (at $loc(d) d) }
| COLLISIONS c = NAME { Collisions (at $loc(c) c) }
| BINDING b = NAME { Binding (at $loc(b) b) }
| BONDS b = NAME { Bonds (at $loc(b) b) }
| BLOCKED b = NAME { Blocked (at $loc(b) b) }
| RESOLUTION e = expr { Resolution e }
| ROUND n = NAME e = expr { Round (at $loc(n) n, e) }
| ROUND VELOCITY e = expr { Round (at $loc($2) "velocity", e) }
| i = import { Import i }
| SHAPE h = head EQ s = solid ds = definitions { Shape (h, s, ds) }
| SHAPE h = head LBRACE t = template RBRACE ds = definitions { Shape (h, at $loc(t) t, ds) }
| COMPOUND h = head LBRACE parts = many(part) glues = many(glue) RBRACE ds = definitions
    { Compound (h, parts, glues, ds) }
| COMPOUND h = head EQ DECOMPOSE s = decomposed attributes = many(attribute) ds = definitions
    { Decomposed (h, s, attributes, ds) }
| BEHAVIOUR h = behaviour_head EQ b = behaviour ds = definitions { Behaviour (h, None, b, ds) }
| BEHAVIOUR h = behaviour_head ON t = reference EQ b = behaviour ds = definitions { Behaviour (h, Some t, b, ds) }
| PROCESS s = segment EQ c = chain(moving) { Process (s, c.head, List.rev c.tail) }
| FIXED s = segment EQ c = chain(still) { Fixed (s, c.head, List.rev c.tail) }
| BOND b = bond { Bond b }
| FOR ranges = comma_list(range) LBRACE body = many(item) RBRACE { For (ranges, body) }
| NETWORK NIL { Network [] }
| NETWORK p = path ps = many(parallel) { Network (p :: ps) }
| MOTION l = law_of_all { Motion (None, l) }
| MOTION p = path EQ l = law { Motion (Some p, l) }
| LET n = name EQ e = expr { Let (n, e) }
| CHECK n = name COLON e = expr { Check (n, e) }
