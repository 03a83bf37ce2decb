(** The network: which of the declared processes take part, and the bonds, motions and names that go with
    them. *)

open Scc_calculus

type t = {
  included : bool array;  (** by number of the declared leaf *)
  index : int array;  (** its index in the model, or -1 *)
  laws : (Law.t * Scc_base.Span.t) array;  (** with their places, by number of the declared leaf *)
}

val read : Context.t -> Program.t -> Bodies.t -> t

val single : Report.t -> Env.t -> Scc_syntax.Ast.path -> (string * Scc_base.Span.t) option
(** The printed name of a body: one segment, with its indices evaluated. *)
