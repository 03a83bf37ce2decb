open Scc_json
open Scc_loading
open Json_format

let named name text t = named ~file:Shared.file name (about text t)
let parameters_format =
  named "parameters" "The values of the model's parameters in this run." (entries Shared.rational)

let settings_format =
  named "settings"
    "The parameters of the semantics that can matter to the model, as \"split step\", \"timestep\", \"dynamics\", \
     \"resolution\"."
    (entries some_text)

let identity =
  all
    [
      field "digest" Shared.digest (fun (o : Origin.t) -> o.digest);
      field "parameters" parameters_format (fun (o : Origin.t) -> o.parameters);
      field "settings" settings_format (fun (o : Origin.t) -> o.settings);
    ]

let fields =
  let name = field "model" (nullable text) ~about:"The name that the model gives itself." in
  all [ name (fun (o : Origin.t) -> o.name); identity ]

let parameters (o : Origin.t) = write parameters_format o.parameters
let settings (o : Origin.t) = write settings_format o.settings
