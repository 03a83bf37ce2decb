(** The pieces of a model on one line each, in canonical form: ASCII, with the fewest parentheses that the
    precedence of operators allows. *)

val expr : Ast.expr -> string
(** [expr e] is a number, vector, law or formula. *)

val condition : Ast.expr -> string
(** [condition f] is [f] as the left side of [leads_to]. *)

val consequence : Ast.bound option -> Ast.expr -> string
(** [consequence bound g] is the word [leads_to] with its bound and its right side [g]. *)

(** An operand of a binary operator. *)
type side = Left | Right

val needs_parentheses : Ast.binary -> side -> Ast.expr -> bool
(** [needs_parentheses o side e] is true if [e] needs parentheses as that operand of [o]. *)

val segment : Ast.segment -> string
(** [segment s] is a name with its indices, such as [c[i, j]]. *)

val path : Ast.path -> string
(** [path p] is its segments with dots between them, such as [c[i].left]. *)

val vector : Ast.vector -> string
(** [vector e] is a vector as an attribute or a factor: in parentheses, unless it is a name or a call. *)

val law_of_all : Ast.vector -> string
(** [law_of_all e] is a vector as the law after [motion] without a process: in parentheses, unless it is a call
    or a conditional expression. *)

val reference : Ast.reference -> string
(** [reference r] is the name of a shape or behaviour with its module, indices and arguments, such as
    [m.Brick(1, 2)]. *)

val head : Ast.head -> string
(** [head h] is the left side of a declaration with its indices and arguments, such as [K[i, 0]] or
    [Brick(a, b)]. *)

val bounds : Ast.bounds -> string
(** [bounds r] is a range of integers with its condition: [1..n if c]. *)

val feature : Ast.feature -> string
(** [feature f] is a path, or the corners of a face or an edge in brackets: [top], [q.[a, b]]. *)

val bond : Ast.bond -> string
(** [bond b] is a bond of a process: its channel and its two features, as [<a, {p.top, q.bottom}>]. *)

val behaviour : Ast.behaviour -> string
(** [behaviour b] is a whole behaviour. *)

val prefixes : Ast.behaviour -> (int * string) list
(** [prefixes b] cuts the behaviour [b] after each dot. Each piece has its offset in the source. A sum is one
    piece, in parentheses. *)

val vertex : Ast.name * Ast.vector -> string
(** [vertex v] is a name with its point: [a (0, 0, 1)]. *)

val quoted : string -> string
(** [quoted s] is [s] between quotation marks. Quotation marks and backslashes in it have a backslash before
    them. *)

val face : Ast.name -> Ast.name list -> string
(** [face n vs] is a name with its vertices: [top [a, b, c]]. *)

val solid : Ast.solid -> string
(** [solid s] is any solid. Vertices and faces are in braces, which the grammar allows in a declaration only. *)

val decomposed : Ast.solid -> string
(** [decomposed s] is the solid after [decompose]: a file stands without the word [mesh]. *)

val attribute : Ast.attribute -> string
(** [attribute a] is a mass, velocity, spin, placement or [absorb] with its word, such as [mass 2]. *)
