open Scc_session

let parameters (o : Origin.t) = `Assoc (List.map (fun (name, value) -> (name, Json.rat value)) o.parameters)

let members (o : Origin.t) =
  [ ("model", Json.option Json.text o.name); ("digest", `String o.digest); ("parameters", parameters o) ]
