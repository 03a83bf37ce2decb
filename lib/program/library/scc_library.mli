(** The Shape Calculus for other programs in OCaml: load a model, follow its transitions, check its properties, and
    draw its states and runs. This interface names no other module of scc. Numbers are exact: rationals of Zarith.

    {[
      match Scc_library.load_file "hexokinase.sc" with
      | Error problems -> List.iter (fun (p : Scc_library.problem) -> prerr_string p.text) problems
      | Ok model -> (
          match Scc_library.check model with
          | Error _ -> ()
          | Ok { verdicts; _ } ->
            let show (v : Scc_library.verdict) = Printf.printf "%s: %s\n" v.name v.text in
            List.iter show verdicts)
    ]}

    Nothing is printed, and no signal is handled. A fault of scc itself is the exception [Scc_base.Bug.Bug]. *)

(** {1 Models} *)

type model
(** A model that was read, with values for its parameters. *)

(** An error or a warning about a model. *)
type problem = {
  code : string;  (** such as ["SC0201"]; it never changes its meaning *)
  is_error : bool;  (** false for a warning *)
  message : string;  (** one sentence, without its full stop *)
  place : (string * int * int) option;  (** file, line and column; both begin with 1 *)
  hint : string option;  (** what may help *)
  text : string;  (** all of it for people, with an excerpt of the model, in lines *)
}

val load :
  ?read:(string -> (string, string) result) ->
  ?set:(string * Q.t) list ->
  ?name:string ->
  string ->
  (model, problem list) result
(** [load text] reads the text of a model. [read] returns the content of a file that the model imports or takes a
    shape from, by its path as written there, or says why it cannot; by default it refuses all. [set] gives
    parameters their values; [Q.inf] and [Q.undef] are refused (SC0208). [name] is the file that problems name, by
    default ["<model>"]; its ending selects the notation ([.sc], [.xml], [.osc]). *)

val load_file : ?set:(string * Q.t) list -> string -> (model, problem list) result
(** [load_file path] reads a model from a file, and the files that it names from the folder of that file. *)

val warnings : model -> problem list
(** What is odd about the model, but does not prevent its use. *)

(** {1 Transitions} *)

type state
(** A state of a model. *)

(** A body of a state. *)
type body = {
  body : string;  (** its name in the model *)
  position : Q.t * Q.t * Q.t;  (** of its centroid, in the world *)
  behaviour : string;  (** its term, in the language of models *)
}

(** A transition from a state. *)
type transition = {
  kind : string;
  (** ["time"], ["bind"], ["close"], ["bounce"], ["absorb"], ["weak"], ["strong"], ["draw"] or ["lot"] *)
  label : string;  (** such as ["time(5/2)"] or ["bind(a, p.right, q.left)"] *)
  duration : Q.t;  (** the time that passes: 0 unless the kind is ["time"] *)
  chance : Q.t option;  (** its probability, if chance decides among the transitions of the state *)
  target : state;
}

val initial : model -> (state, problem list) result
(** The state in which the runs of the model begin. An error is a parameter with a range but no value (SC0903),
    bonds that may be released at any time (SC0902), or a law of motion without a value. *)

val successors : model -> state -> (transition list, problem list) result
(** All transitions of a state of this model, in a fixed order. The list is empty if the state has none. An error
    says why they cannot be computed. *)

val quiescent : model -> state -> bool
(** [quiescent model state] is true if nothing can ever happen again. *)

val bodies : model -> state -> body list
(** The bodies of a state, in the order of the model, without those that were absorbed. *)

val equal : state -> state -> bool
(** [equal a b] is true if the two states of one model are the same state (rule State). *)

val hash : state -> int
(** A hash of a state. Equal states have equal hashes. *)

(** {1 Checks} *)

(** The answer to one check. *)
type verdict = {
  name : string;
  formula : string;
  kind : string;  (** ["holds"], ["holds-up-to-bound"], ["violated"], ["measured"] or ["undecided"] *)
  text : string;  (** the verdict in full, such as ["holds (exhaustive), at split step 1"] *)
}

(** The answers to all checks of a model. *)
type report = {
  verdicts : verdict list;  (** in the order of the model *)
  states : int;  (** that were explored *)
  transitions : int;
  complete : bool;  (** no bound left anything out *)
  json : (string -> unit) -> unit;
  (** writes the report of [scc check --json], piece by piece, with runs that show the verdicts *)
}

val check :
  ?states:int -> ?depth:int -> ?stop:(unit -> bool) -> model -> (report, problem list) result
(** Explores the model and decides its checks, in this process. At most [states] states are kept (200 000 by
    default), and only those are expanded that at most [depth] transitions lead to. The exploration ends early once
    [stop ()] is true; what was found until then is the answer. Negative bounds are refused (SC0208). *)

(** {1 Pictures} *)

val picture : model -> state -> string
(** The drawing of a state, as an SVG file. *)

val page : ?states:int -> title:string -> model -> (string -> unit) -> (unit, problem list) result
(** [page ~title model write] writes a page that shows the runs of the model in a browser: one HTML file, as of
    [scc view]. It has the runs that show the verdicts, and at most [states] states in all (1000 by default;
    negative numbers are refused). If a parameter has a range, the states are those of one start, each run has the
    start that its verdict names, and a drawing shows where the checks hold. *)
