open Scc_loading

type surroundings = {
  now : unit -> float;
  bounded : 'a. seconds:float -> (unit -> 'a) -> ('a, Fault.stop) result;
  passes : exn -> bool;
  read_file : Loaded.reader;
}

let quiet =
  {
    now = (fun () -> 0.);
    bounded = (fun ~seconds:_ f -> Ok (f ()));
    passes = (fun _ -> false);
    read_file = Models.no_files;
  }

type t = {
  quotas : Quotas.t;
  version : string;
  surroundings : surroundings;
  shapes : Shapes.store;
  models : Models.store;
}

let create ?(quotas = Quotas.default) ?(surroundings = quiet) ~version () =
  let models = Models.store quotas ~read_file:surroundings.read_file in
  { quotas; version; surroundings; shapes = Shapes.store quotas; models }

let distrust t =
  Shapes.forget t.shapes;
  Models.forget t.models
