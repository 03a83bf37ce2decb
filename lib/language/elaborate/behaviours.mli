(** Behaviours (Definition 5.1) on shapes. A definition K is elaborated once for each structure of shape that
    it is used on, as its features are then the same; both entries bear the name K. *)

open Scc_base
open Scc_syntax
open Scc_calculus

type t

(** Whose behaviour it is. *)
type owner = {
  name : string;  (** the leaf *)
  shape : Shape.t;
  span : Span.t;
}

val create : Context.t -> Program.t -> t

val term : t -> Env.t -> owner -> Ast.behaviour -> Behaviour.t option
(** A behaviour written at a process. *)

val definition : t -> Env.t -> owner -> Ast.reference -> int option
(** The index of K on the owner's shape. *)

val use_channel : t -> string -> unit
(** A channel name that a bond bears. *)

val settle : t -> unit
(** Elaborates the definitions that were asked for. *)

val has_channel : t -> string -> bool
(** Whether something elaborated so far bears the channel name. *)

val channels : t -> string list
(** The channel names of everything elaborated so far, sorted. *)

val seal : t -> unit
(** What is asked for from now on is checked but is not part of the model. *)

val finish : t -> Behaviour.definitions
(** All that was asked for before {!seal}; to be called once, last. Checks guardedness (SC0501) and that no
    definition names the features of one process while another has it; reads the definitions that nothing
    uses for their faults. *)
