open Scc_json
open Scc_loading

let parameters (o : Origin.t) = `Assoc (List.map (fun (name, value) -> (name, Json.rat value)) o.parameters)

let settings (o : Origin.t) = `Assoc (List.map (fun (name, value) -> (name, `String value)) o.settings)

let members (o : Origin.t) =
  [
    ("model", Json.option Json.text o.name);
    ("digest", `String o.digest);
    ("parameters", parameters o);
    ("settings", settings o);
  ]
