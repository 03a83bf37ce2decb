(** The explicit files of probabilistic model checkers: transitions (.tra), labels (.lab) and states (.sta) of
    the graph as an MDP ({!Mdp}), in two dialects.

    {v
            PRISM                               Storm
    .tra    'states choices transitions' first  'mdp' first
            'i k j 1 action'                    'i k j 1'
    .lab    '0="init" 1="deadlock"' first       '#DECLARATION', the names, '#END' first
            'i: 0 2'                            'i init goal'
    .clab   none                                the actions, like .lab: 'i k action'
    v}

    Neither has comments, and their numbers are floats: what names stand for is in a file beside them, and
    durations are in the names of actions only ({!Drn} has them as rewards). *)

type dialect = Prism | Storm

val transitions : dialect -> Mdp.t -> (string -> unit) -> unit
val labels : dialect -> Mdp.t -> (string -> unit) -> unit

val choice_labels : Mdp.t -> (string -> unit) -> unit
(** For Storm. *)

val states : Mdp.t -> State_variables.t -> (string -> unit) -> unit
(** As PRISM writes them; Storm reads none. *)

val names : Exported.t -> Mdp.t -> State_variables.t -> (string -> unit) -> unit
(** What labels, actions and the values of variables stand for, and what to ask for the model's checks
    ({!Pctl}); see [specs/schema/names.schema.json]. *)
