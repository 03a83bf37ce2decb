open Scc_json

type t = {
  encoding : Positions.encoding;
  markdown : bool;
  snippets : bool;
  places : bool;
  related : bool;
  progress : bool;
  versioned : bool;
  shows : bool;
  watches : bool;
  fresh_lenses : bool;
  fresh_values : bool;
  folders : string list;
}

let rec find path json =
  match path with
  | [] -> Some json
  | name :: rest -> Option.bind (Json.member name json) (find rest)

let texts = function Some (`List items) -> List.filter_map Json.string items | _ -> []

let folders params =
  let of_folder f = Option.bind (Option.bind (Json.member "uri" f) Json.string) Uri.path in
  match Json.member "workspaceFolders" params with
  | Some (`List all) -> List.filter_map of_folder all
  | _ ->
    let root = Option.bind (Json.member "rootUri" params) Json.string in
    Option.to_list (Option.bind root Uri.path)

let read params =
  let at path = find ("capabilities" :: path) params in
  let can path = match at path with Some (`Bool b) -> b | _ -> false in
  {
    encoding = Positions.chosen (texts (at [ "general"; "positionEncodings" ]));
    markdown = List.mem "markdown" (texts (at [ "textDocument"; "hover"; "contentFormat" ]));
    snippets = can [ "textDocument"; "completion"; "completionItem"; "snippetSupport" ];
    places =
      can
        [
          "textDocument"; "signatureHelp"; "signatureInformation"; "parameterInformation"; "labelOffsetSupport";
        ];
    related = can [ "textDocument"; "publishDiagnostics"; "relatedInformation" ];
    progress = can [ "window"; "workDoneProgress" ];
    versioned = can [ "workspace"; "workspaceEdit"; "documentChanges" ];
    shows = can [ "window"; "showDocument"; "support" ];
    watches = can [ "workspace"; "didChangeWatchedFiles"; "dynamicRegistration" ];
    fresh_lenses = can [ "workspace"; "codeLens"; "refreshSupport" ];
    fresh_values = can [ "workspace"; "inlayHint"; "refreshSupport" ];
    folders = folders params;
  }
