(** The explicit format of the model checker Storm (DRN), with exact rationals. *)

val write : Exported.t -> Mdp.t -> (string -> unit) -> unit
(** The MDP ({!Mdp}), with its labels, and with the time that passes as the reward model [time]: the reward of
    an action is its duration. What labels and actions stand for, and what to ask for the model's checks
    ({!Pctl}), is told in comments. *)
