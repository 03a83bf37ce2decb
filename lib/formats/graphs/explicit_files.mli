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

    Neither has comments, and their numbers are floats. The meanings of names are in a file beside them. Durations
    are in the names of actions only ({!Drn} has them as rewards). *)

(** The program for which the files are written. *)
type dialect = Prism | Storm

val transitions : dialect -> Mdp.t -> (string -> unit) -> unit
(** Writes the [.tra] file. *)

val labels : dialect -> Mdp.t -> (string -> unit) -> unit
(** Writes the [.lab] file. *)

val choice_labels : Mdp.t -> (string -> unit) -> unit
(** Writes the [.clab] file, for Storm: the action of each choice. *)

val states : Mdp.t -> State_variables.t -> (string -> unit) -> unit
(** Writes the [.sta] file in the form of PRISM; Storm reads none. *)

val name_format : (string, string) Scc_json.Json_format.t
(** The format of a name of a label, an action or a variable. *)

(** A graph with its variables. *)
type names

val names_format : (names, unit) Scc_json.Json_format.t
(** The format of {!names}. *)

val names : Exported.t -> Mdp.t -> State_variables.t -> (string -> unit) -> unit
(** Writes the meanings of labels, actions and values of variables, and the formulas of the model's checks
    ({!Pctl}). See [specs/schema/names.schema.json]. *)
