(** Errors of the translation, as an exception within it. *)

open Scc_base

(** The error that ends a translation. *)
exception Found of Diag.t

val refuse :
  ?hint:string -> ?notes:(Span.t * string) list -> Code.t -> Span.t -> ('a, unit, string, 'b) format4 -> 'a
(** [refuse code at fmt …] raises {!Found} with an error. *)

val ok : ('a, Diag.t) result -> 'a
(** The value of a result; raises {!Found} with its error. *)

val catch : (unit -> 'a) -> ('a, Diag.t) result
(** [catch f] is the result of [f ()], with the error of {!Found} if it is raised. *)
