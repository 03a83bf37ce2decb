(** The explicit format of the model checker Storm (DRN), with exact rationals. *)

val write : Exported.t -> Mdp.t -> (string -> unit) -> unit
(** Writes the MDP ({!Mdp}) with its labels. The reward model [time] is the time that passes: the reward of an
    action is its duration. Comments explain labels and actions, and list the formulas of the model's checks
    ({!Pctl}). Where no action takes time, there is one more state with a reward, to which no transition leads:
    Storm refuses questions about a reward model whose rewards are all 0. *)
