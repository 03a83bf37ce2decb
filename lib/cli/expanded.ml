open Scc_base
open Scc_exact
open Scc_space
open Scc_session
open Scc_store
module Crew = Scc_expand.Crew
module Crew_of_states = Crew.Make (Network_lts) (Network_exchange) (State_graph)
module Journal_of_states = Scc_expand.Journal.Make (Network_lts) (Network_exchange) (State_graph)

type t = { jobs : int; start : Crew.start; store : Store.t option }

(* Of two builds that call themselves by one version, one may have a fault that the other has not: what one has
   found is not taken over by the other. *)
let build () =
  match Digest.file Sys.executable_name with
  | digest -> Digest.to_hex digest
  | exception Sys_error _ -> "unknown"

(* What explorations depend on. *)
let identity (l : Loaded.t) options =
  let values = List.map (fun (name, q) -> ("parameter " ^ name, Rat.to_string q)) l.origin.parameters in
  [ ("scc", Version.told); ("the build of scc", build ()); ("the model", l.origin.digest) ] @ values @ options

let opened (l : Loaded.t) options folder = Store.openly folder ~identity:(identity l options)

let openly ~jobs ~store ~memory options l =
  let with_store store =
    match jobs with
    | Some jobs -> { jobs; start = At_once; store }
    | None -> { jobs = Cores.available (); start = When_it_pays; store }
  in
  match store with
  | None -> Ok (with_store None)
  | Some folder -> (
      match opened l options folder with
      | Ok store ->
        Scc_data.Spill.to_folder folder ~beyond:(Memory.bytes_of_words memory / 4);
        Ok (with_store (Some store))
      | Error d -> Error [ d ])

let expanding t ~about =
  let crew = Crew_of_states.expanding ~jobs:t.jobs ~start:t.start in
  match t.store with
  | None -> crew
  | Some store -> Journal_of_states.expanding (Store.log store about) crew

let guard t explore =
  match explore () with
  | result -> result
  | exception Scc_expand.Journal.Unfit what ->
    let folder = Option.fold ~none:"" ~some:Store.folder t.store in
    Error
      [
        Diag.error Code.damaged_store
          (Span.make ~file:folder ~start:0 ~stop:0)
          "the store does not fit the exploration: %s" what
          ~hint:"remove the folder to begin anew";
      ]

let no_sets =
  Error
    [
      Diag.error Code.not_yet Span.none
        "this model is explored by sets of states, as it leaves values or instants open, and a store keeps states"
        ~hint:"leave out --store; or give all parameters values, and a `split_step`";
    ]

let close t =
  match t.store with
  | None -> []
  | Some store ->
    Scc_data.Spill.nowhere ();
    Store.close store;
    Option.to_list (Store.failed store)
