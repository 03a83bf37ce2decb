(** The methods [contact] and [first_time_of_contact] for two shapes. The reference point of the first is the
    origin. *)

val contact : Shapes.store Method.t
(** The method [contact]: the relation of two shapes at an offset, and where they touch. *)

val first_time_of_contact : Shapes.store Method.t
(** The method [first_time_of_contact] of two shapes in relative motion. With [span] or [until] they may also
    turn. *)

(** {1 Params of two shapes} *)

val a : string Read.member
(** The param [a]: the handle of the first shape. *)

val b : string Read.member
(** The param [b]: the handle of the second shape. *)

val offset : Scc_exact.Vec.t Read.member
(** The param [offset]: where the second shape is. *)

val velocity : Scc_exact.Vec.t Read.member
(** The param [velocity]. *)

val turned_a : Scc_exact.Quaternion.t Read.member
(** The param [turned_a]: how the first shape is turned. *)

val turned_b : Scc_exact.Quaternion.t Read.member
(** The param [turned_b]: how the second shape is turned. *)

val resolution : Scc_exact.Rat.t Read.member
(** The param [resolution] of the dynamics of rigid bodies. *)

val relation : Scc_geometry.Obstacle.relation -> string
(** The name of a relation: ["apart"], ["touching"] or ["interpenetrating"]. *)
