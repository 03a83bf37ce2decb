open Scc_json

type t = {
  name : string;
  path : string option;
  read : string -> (string, string) result;
  write : string -> string -> (unit, string) result;
  parameters : (string * Json.t) list;
  start : string;
}

let digest text = "md5:" ^ Digest.to_hex (Digest.string text)

(* What is in the file, if it is there. *)
let present t path = if Sys.file_exists path then Result.map Option.some (t.read path) else Ok None

(* What is no text would be another file when it is saved. *)
let is_text bytes = match Json.text bytes with `String text -> String.equal text bytes | _ -> false

let page_data t : Json.t =
  let text, saved, why =
    match t.path with
    | None -> (t.start, None, None)
    | Some path -> (
        match present t path with
        | Ok (Some text) when not (is_text text) -> ("", None, Some "it is not UTF-8 text")
        | Ok (Some text) -> (text, Some (digest text), None)
        | Ok None -> (t.start, None, None)
        | Error why -> ("", None, Some why))
  in
  let text_of = Json.option Json.text in
  `Assoc
    [
      ("name", Json.text t.name);
      ("path", text_of t.path);
      ("text", Json.text text);
      ("saved", text_of saved);
      ("unreadable", text_of why);
      ("parameters", `Assoc t.parameters);
    ]

type saved = Saved of string | Another of { text : string; digest : string } | Failed of string

let save t ~text ~over =
  match t.path with
  | None -> Failed "scc serve was started without a model, and has no file to save to"
  | Some path -> (
      let put () =
        match t.write path text with Ok () -> Saved (digest text) | Error why -> Failed why
      in
      match present t path with
      | Error why -> Failed why
      | Ok None when Option.is_none over -> put ()
      | Ok None -> Another { text = ""; digest = "" }
      | Ok (Some there) when Option.equal String.equal over (Some (digest there)) -> put ()
      | Ok (Some there) when not (is_text there) -> Failed "what is in the file is not UTF-8 text"
      | Ok (Some there) -> Another { text = there; digest = digest there })
