(** What all algebras do alike with numbers, truth values and vectors: constants are worked out exactly and within
    limits, and functions are written with the operators ([min(a, b)] is [if a <= b then a else b]), so that no
    algebra has to know them. *)

open Scc_base
open Scc_syntax
open Scc_calculus
open Algebra

val functions : string list
val described : ('n, 'c) value -> string
val unknown_function : Report.t -> Ast.name -> string list -> unit
val both : 'a option -> 'b option -> ('a * 'b) option

val copies : string -> int
(** How often an argument of a function that is no constant is written out. *)

module Make (A : Algebra.S) : sig
  val error :
    A.context -> ?hint:string -> Code.t -> Span.t -> ('a, unit, string, unit) format4 -> 'a

  val ( let* ) : 'a option -> ('a -> 'b option) -> 'b option

  (** {2 Types} *)

  val num : A.num option -> (A.num, A.cond) value option
  val as_num : A.context -> Span.t -> (A.num, A.cond) value option -> A.num option
  val as_cond : A.context -> Span.t -> (A.num, A.cond) value option -> A.cond option
  val as_vec : A.context -> Span.t -> (A.num, A.cond) value option -> (A.num * A.num * A.num) option

  val is_constant : (A.num, A.cond) value -> bool

  (** {2 Truth} *)

  val negate : A.cond -> A.cond
  val conj : A.cond -> A.cond -> A.cond
  val connective : Ast.binary -> A.cond -> A.cond -> A.cond
  val comparison_of : Ast.binary -> Law.comparison option
  val compare : Law.comparison -> A.num -> A.num -> A.cond
  val choose : A.context -> Span.t -> A.cond -> A.num -> A.num -> A.num option

  (** {2 Numbers and vectors} *)

  val negated : A.num -> A.num

  val each :
    ('a -> 'b -> A.num option) -> 'a * 'a * 'a -> 'b * 'b * 'b -> (A.num, A.cond) value option
  (** Component by component. *)

  val operate :
    A.context ->
    Span.t ->
    Ast.binary ->
    (A.num, A.cond) value ->
    (A.num, A.cond) value ->
    (A.num, A.cond) value option
  (** [+ - * / mod]. *)

  val check_arity : A.context -> Span.t -> string -> int -> unit
  (** Reports (SC0206) that the function, one of {!functions}, cannot have so many arguments. *)

  val call :
    A.context -> Span.t -> string -> (A.num, A.cond) value list -> (A.num, A.cond) value option
  (** One of {!functions}. *)

  val all : 'a option list -> 'a list option
end
