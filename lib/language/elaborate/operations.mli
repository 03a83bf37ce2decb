(** Operations on numbers, truth values and vectors that all algebras share. Constants are computed exactly and
    within limits. Functions are written with operators ([min(a, b)] is [if a <= b then a else b]), so an
    algebra need not implement them. *)

open Scc_base
open Scc_syntax
open Scc_calculus
open Algebra

val functions : string list
(** The functions of numbers and vectors that every algebra has, in alphabetical order. *)

val described : ('n, 'c) value -> string
(** The kind of a value as a text: ["a number"], ["a vector"] or ["a truth value"]. *)

val unknown_function : Report.t -> Ast.name -> string list -> unit
(** [unknown_function report f known] reports an unknown function (SC0201). The message lists [known],
    sorted. *)

val both : 'a option -> 'b option -> ('a * 'b) option
(** [both a b] is the pair of two results, or [None] if one is [None]. *)

val copies : string -> int
(** [copies f] is the number of times that the expansion of [f] contains an argument that is no constant. *)

module Make (A : Algebra.S) : sig
  val error :
    A.context -> ?hint:string -> Code.t -> Span.t -> ('a, unit, string, unit) format4 -> 'a
  (** Reports an error as {!Report.error} does. *)

  (** {2 Types} *)

  val num : A.num option -> (A.num, A.cond) value option
  (** A number as a value. *)

  val as_num : A.context -> Span.t -> (A.num, A.cond) value option -> A.num option
  (** The number of a value. A value of another kind is an error (SC0205) at the span. *)

  val as_cond : A.context -> Span.t -> (A.num, A.cond) value option -> A.cond option
  (** The truth value of a value. A value of another kind is an error (SC0205) at the span. *)

  val as_vec : A.context -> Span.t -> (A.num, A.cond) value option -> (A.num * A.num * A.num) option
  (** The components of a vector. A value of another kind is an error (SC0205) at the span. *)

  val is_constant : (A.num, A.cond) value -> bool
  (** [is_constant v] is true if the number, the truth value, or each component of the vector is a constant. *)

  (** {2 Truth} *)

  val negate : A.cond -> A.cond
  (** Negation; the result is a constant if the operand is one. *)

  val conj : A.cond -> A.cond -> A.cond
  (** Conjunction; the result is a constant if the operands determine one. *)

  val connective : Ast.binary -> A.cond -> A.cond -> A.cond
  (** [and], [or] or [=>] on truth values. Any other operator is a bug. *)

  val comparison_of : Ast.binary -> Law.comparison option
  (** The comparison of an operator such as [<=], and [None] for any other operator. *)

  val compare : Law.comparison -> A.num -> A.num -> A.cond
  (** Comparison of two numbers; the result is a constant if both operands are. *)

  val choose : A.context -> Span.t -> A.cond -> A.num -> A.num -> A.num option
  (** [choose ctx at c a b] is [if c then a else b], or one of the two if [c] is a constant. [None] is a fault,
      which is reported at [at]. *)

  (** {2 Numbers and vectors} *)

  val negated : A.num -> A.num
  (** The negative of a number; the result is a constant if the operand is one. *)

  val each :
    ('a -> 'b -> A.num option) -> 'a * 'a * 'a -> 'b * 'b * 'b -> (A.num, A.cond) value option
  (** [each f v w] is the vector of [f] on the components of [v] and [w], one by one. *)

  val operate :
    A.context ->
    Span.t ->
    Ast.binary ->
    (A.num, A.cond) value ->
    (A.num, A.cond) value ->
    (A.num, A.cond) value option
  (** [operate ctx at op a b] is [+], [-], [*], [/] or [mod] on numbers and vectors. Operands that do not fit
      are SC0205, a division by zero SC0207, and too large a constant SC0106. *)

  val check_arity : A.context -> Span.t -> string -> int -> unit
  (** Reports that the function, one of {!functions}, cannot have this number of arguments (SC0206). *)

  val call :
    A.context -> Span.t -> string -> (A.num, A.cond) value list -> (A.num, A.cond) value option
  (** [call ctx at f arguments] is the value of [f], one of {!functions}. Arguments that do not fit are
      SC0206. *)

  val all : 'a option list -> 'a list option
  (** The values of a list of results, or [None] if one of them is [None]. *)
end
