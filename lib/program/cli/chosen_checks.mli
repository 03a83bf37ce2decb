(** The option [--check NAME] of the commands that decide or estimate some of a model's checks. *)

open Scc_base
open Scc_property
open Scc_loading

val option : doc:string -> string list Cmdliner.Term.t
(** [option ~doc] is [--check NAME], repeatable: the names in the order of the command line. *)

val of_names : Loaded.t -> string list -> (Property.check list, Diag.t list) result
(** [of_names l names] is the checks of the model with these names, in the order of the names. A name without
    indices stands for all checks of a family, of which there may be none. An unknown name is SC0201; the nearest
    name is its hint. *)

val only : Loaded.t -> string list -> (Loaded.t, Diag.t list) result
(** [only l names] is the model with these of its checks, in the order of the model, and their premises. No names
    stand for all checks. An unknown name is SC0201, as in {!of_names}. *)
