(** The names of bodies: leaves, processes with several leaves, and families ([c] for all [c[i]]). *)

open Scc_base
open Scc_syntax

type target =
  | Leaf of int  (** its number in the order of declaration *)
  | Process of int list  (** the leaves of a process that has labels for them *)
  | Family of int list

type t

val create : Report.t -> t

val add : t -> Ast.segment -> string -> target -> unit
(** A leaf or a process, by its printed name ([c[3]]), and its leaves into the family of an indexed name.
    SC0202 when the name is taken. *)

val find : t -> string -> target option
val span : t -> string -> Span.t option
val names : t -> string list
