(** The settings of a model, each given at most once (SC0212). [collisions], [binding] and [bonds] are those of
    readings I-32, I-33 and I-37; [blocked] is that of rule Blocked. [dynamics], [resolution] and [round] belong to
    rigid motion (rules Turn and Round). *)

open Scc_base
open Scc_syntax
open Scc_calculus

(** The settings read so far. *)
type t

val create : unit -> t
(** No settings yet. *)

val dynamics : t -> Report.t -> Ast.name -> unit
(** Reads [dynamics]: [constant_spin] or [free_body]. Any other word is SC0201. *)

val read_collisions : t -> Report.t -> Ast.name -> unit
(** Reads [collisions]: [in_turn], [together] or [drawn]. Any other word is SC0201. *)

val read_binding : t -> Report.t -> Ast.name -> unit
(** Reads [binding]: [collision] or [contact]. Any other word is SC0201. *)

val read_bonds : t -> Report.t -> Ast.name -> unit
(** Reads [bonds]: [acyclic] or [cyclic]. Any other word is SC0201. *)

val read_blocked : t -> Report.t -> Ast.name -> unit
(** Reads [blocked]: [bounce], [stop] or [wait]. Any other word is SC0201. *)

val resolution : t -> Report.t -> Env.t -> Ast.expr -> unit
(** Reads [resolution]: a positive length (SC0208 otherwise). *)

val round : t -> Report.t -> Env.t -> Ast.name -> Ast.expr -> unit
(** Reads [round] for [orientation] or [velocity] (SC0201 otherwise). The step is 2^-k with k > 0 (SC0208
    otherwise). *)

val rigid : t -> Report.t -> spinning:(string * Span.t) option -> Model.leaf array -> Model.rigid option
(** The settings of rigid motion of a network with these leaves, or [None] if nothing turns. Bodies turn if
    one is given a spin, by its declaration or by a law ([spinning]), or [dynamics] is given. A spin without
    [dynamics] is a warning (SC0215). Otherwise the settings that are given have no effect (warning SC0213).

    A resolution of more than an eighth of the shortest edge is coarse (warning SC0214). Without a resolution it
    is the greatest power of two that is at most 2^-20 times the shortest edge. *)

val collisions : t -> Model.collisions
(** The setting of [collisions]; [In_turn] by default. *)

val round_velocity : t -> int option
(** k, if velocities are rounded to multiples of 2^-k. *)

val binding : t -> Model.binding
(** The setting of [binding]; [On_collision] by default. *)

val bonds : t -> Model.bonds
(** The setting of [bonds]; [Acyclic] by default. *)

val blocked : t -> Model.blocked
(** The setting of [blocked]; [Bounce] by default. *)

val check : t -> Report.t -> spins:bool -> unit
(** Reports [On_contact] in a model whose bodies turn, and [Stop] and [Wait] there or where velocities are rounded
    (SC0901). [spins] is true if a body is given a spin, by its declaration
    or by a law. *)
