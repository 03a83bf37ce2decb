(** The network: the declared processes that take part, with their bonds, laws of motion and names. *)

open Scc_calculus

type t = {
  included : bool array;  (** by number of the declared leaf *)
  index : int array;  (** its index in the model, or -1 *)
  laws : (Law.t * Scc_base.Span.t) array;  (** with their places, by number of the declared leaf *)
  lattices : Lattices.t list;  (** of all that take part *)
}

val read : Context.t -> Program.t -> Bodies.t -> t
(** Reads [network] and [motion]. Without [network] all declared processes take part. A law for one process goes
    before one for its family, and that before the general law. *)

val single : Report.t -> Env.t -> Scc_syntax.Ast.path -> (string * Scc_base.Span.t) option
(** The printed name of a body, with its place: one segment with its indices evaluated. A longer path is
    SC0210. *)
