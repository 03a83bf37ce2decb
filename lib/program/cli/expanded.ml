open Scc_base
open Scc_state_space
open Scc_loading
open Scc_store
module Crew = Scc_parallel.Crew
module Crew_of_states = Crew.Make (Network_lts) (State_graph)
module Journal_of_states = Scc_parallel.Journal.Make (Network_lts) (Network_exchange) (State_graph)
module Journal_of_fingerprints =
  Scc_parallel.Step_journal.Make (Network_lts) (Network_exchange) (State_fingerprints)

type t = { jobs : int; start : Crew.start; store : Store.t option }

let openly console ~jobs ~store ~memory options (l : Loaded.t) =
  let with_store store =
    match jobs with
    | Some jobs -> { jobs; start = At_once; store }
    | None -> { jobs = Cores.available (); start = When_it_pays; store }
  in
  match store with
  | None -> Ok (with_store None)
  | Some folder -> (
      let { Origin.digest; parameters; _ } = l.origin in
      match Kept.openly console ~folder (Kept.identity ~digest ~parameters options) with
      | Ok store ->
        if Option.is_none (Store.failed store) then
          Scc_data.Spill.to_folder folder ~beyond:(Memory.bytes_of_words memory / 4);
        Ok (with_store (Some store))
      | Error _ as refused -> refused)

let expanding t ~about =
  let crew = Crew_of_states.expanding ~jobs:t.jobs ~start:t.start in
  match t.store with
  | None -> crew
  | Some store -> Journal_of_states.expanding (Store.log store about) crew

let compacting t ~about =
  match t.store with
  | None -> State_fingerprints.here
  | Some store -> Journal_of_fingerprints.expanding (Store.log store about)

let guard t explore =
  match explore () with
  | result -> result
  | exception Scc_parallel.Journal.Unfit what ->
    let folder = Option.fold ~none:"" ~some:Store.folder t.store in
    Error
      [
        Diag.error Code.damaged_store
          (Span.of_file folder)
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
