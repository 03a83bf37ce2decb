(** Behaviours (Definition 5.1) on shapes. A definition K is elaborated once for each structure of shape that it
    is used on, since shapes of one structure have the same features. All entries of K have its name. *)

open Scc_syntax
open Scc_calculus

(** Elaborated behaviours, and those that are still due. *)
type t

(** The body that has a behaviour. *)
type owner = {
  name : string;  (** the leaf *)
  shape : Shape.t;
}

val create : Context.t -> Program.t -> t
(** [create c program] has no behaviours yet. It checks the templates after [on] of definitions without
    parameters. *)

val copy : t -> Context.t -> t
(** [copy t c] has the behaviours of [t], and takes what it needs from [c]. Behaviours that one of the two gets
    later are not in the other. [t] must not be finished yet. *)

val count : t -> int
(** The number of definitions that have been requested. *)

val term : t -> Env.t -> owner -> Ast.behaviour -> Behaviour.t option
(** Elaborates a behaviour that is written at a process. Faults are reported and give [None]. *)

val definition : t -> Env.t -> owner -> Ast.reference -> int option
(** The index of a definition on the owner's shape. The definition is elaborated by {!settle} or later. An
    unknown name is SC0201, a wrong template SC0504, more than 10 000 instances SC0111. *)

val use_channel : t -> string -> unit
(** Records the channel name of a bond, so that formulas can use it. *)

val settle : t -> unit
(** Elaborates all definitions that have been requested, and those that these call. *)

val has_channel : t -> string -> bool
(** [has_channel t name] is true if a behaviour or bond read so far has this channel name. *)

val channels : t -> string list
(** The channel names of all behaviours and bonds read so far, sorted. *)

val seal : t -> unit
(** Ends the behaviours of the model. Behaviours requested later are checked but are not part of the model. *)

val finish : t -> Behaviour.definitions
(** The definitions requested before {!seal}. It must be called once, last. Unguarded recursion is SC0501. A
    definition that names the features of one process and is the behaviour of another is SC0203. Unused
    definitions are read for their faults. *)
