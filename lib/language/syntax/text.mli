(** The pieces of a model on one line each, in canonical form: ASCII, and no more parentheses than the
    precedence of operators asks for. *)

val expr : Ast.expr -> string

val condition : Ast.expr -> string
(** The left side of [leads_to]. *)

val consequence : Ast.bound option -> Ast.expr -> string
(** The word [leads_to] with its bound and its right side. *)

type side = Left | Right

val needs_parentheses : Ast.binary -> side -> Ast.expr -> bool
(** Whether an expression must be bracketed as that operand of the operator. *)

val segment : Ast.segment -> string
val path : Ast.path -> string

val vector : Ast.vector -> string
(** As an attribute or a factor: in brackets, but for a name or a call. *)

val law_of_all : Ast.vector -> string
(** After [motion] alone. *)

val reference : Ast.reference -> string
val head : Ast.head -> string

val bounds : Ast.bounds -> string
(** [1..n if c]. *)

val feature : Ast.feature -> string
val bond : Ast.bond -> string

val behaviour : Ast.behaviour -> string
val prefixes : Ast.behaviour -> (int * string) list
(** A behaviour that is no sum, cut after each dot, every piece with its offset. *)

val vertex : Ast.name * Ast.vector -> string
(** [a (0, 0, 1)]. *)

val quoted : string -> string
(** Between quotation marks, as a string is written. *)

val face : Ast.name -> Ast.name list -> string
(** [top [a, b, c]]. *)

val solid : Ast.solid -> string
(** Vertices and faces in braces, which a text has in a declaration only. *)

val decomposed : Ast.solid -> string
(** After [decompose]: a file without the word [mesh]. *)

val attribute : Ast.attribute -> string
