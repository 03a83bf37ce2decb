type surroundings = {
  now : unit -> float;
  bounded : 'a. seconds:float -> (unit -> 'a) -> ('a, Fault.stop) result;
  passes : exn -> bool;
}

let quiet = { now = (fun () -> 0.); bounded = (fun ~seconds:_ f -> Ok (f ())); passes = (fun _ -> false) }

type t = {
  quotas : Quotas.t;
  version : string;
  surroundings : surroundings;
  shapes : Shapes.store;
  models : Models.store;
}

let create ?(quotas = Quotas.default) ?(surroundings = quiet) ~version () =
  { quotas; version; surroundings; shapes = Shapes.store quotas; models = Models.store quotas }

let distrust t =
  Shapes.forget t.shapes;
  Models.forget t.models
