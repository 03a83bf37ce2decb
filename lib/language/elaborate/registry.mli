(** The names of bodies: leaves, processes with several leaves, and families ([c] for all [c[i]]). *)

open Scc_base
open Scc_syntax

type target =
  | Leaf of int  (** its number in the order of declaration *)
  | Process of int list  (** the leaves of a process that has labels for them *)
  | Family of int list

(** The names of the bodies of a model. *)
type t

val create : Report.t -> t
(** No names yet. Names in use are reported to this report. *)

val add : t -> Ast.segment -> string -> target -> unit
(** [add t segment printed target] enters a leaf or a process by its printed name ([c[3]]). If the name has
    indices, its leaves also join the family. A name in use is SC0202. *)

val declare_family : t -> Ast.name -> unit
(** [declare_family t name] enters a family without members, unless the family has members already. A name in use
    for something else is SC0202. *)

val find : t -> string -> target option
(** The body, process or family of a printed name. *)

val hint : t -> ?also:string list -> string -> string option
(** [hint t name] is a hint for a name that no body has. If a family has the name but not the indices, the hint
    lists members. Otherwise it suggests the nearest name, without indices, of [t] and [also]. *)

val unknown : t -> Report.t -> Span.t -> string -> unit
(** [unknown t report at name] reports that no body has the printed name (SC0201), with {!hint}. *)
