(** Fields of the nodes of a scene. Faults raise {!Scene.Refused}, at their places. *)

open Scc_exact

val check : path:string -> Scene.node -> read:string list -> still:string list -> unit
(** A field that is in neither list is a fault (SC0321), unless all its nodes are {!Scene_table.Still}. *)

val words : path:string -> Scene.node -> string -> Text.word list option
(** The words of a field; [None] if the node has no such field. A field that is there twice, or that holds nodes,
    is a fault. *)

val nodes : path:string -> Scene.node -> string -> Scene.node list
(** The nodes in a field, without those that are {!Scene_table.Still}. A field that holds words is a fault. *)

val place : Scene.node -> string -> Text.word
(** The name of a field, at its place; that of the node if it has no such field. *)

val number : path:string -> Scene.node -> string -> default:Rat.t -> Rat.t
(** A field of one number. *)

val numbers : path:string -> Scene.node -> string -> count:int -> Rat.t array option
(** A field of [count] numbers. *)

val integer : path:string -> Scene.node -> string -> default:int -> int
(** A field of one integer. *)

val truth : path:string -> Scene.node -> string -> bool
(** A field of one truth value; true if there is none. *)

val check_all_unseen : path:string -> Scene.node list -> unit
(** A node that would be shown elsewhere, or is not read, is a fault in a field where nothing is shown: one of a
    {!Scene_table.Still} node, or a field of another node that leaves points as they are. Those by which nodes
    are only referred to are left out ({!Scene_table.refers}). *)
