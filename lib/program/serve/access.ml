type t = { port : int; secret : string }

let hexadecimal bytes =
  String.concat "" (List.map (fun c -> Printf.sprintf "%02x" (Char.code c)) (List.of_seq (String.to_seq bytes)))

let make ~port =
  Result.map (fun bytes -> { port; secret = hexadecimal bytes }) (Scc_system.Randomness.bytes 16)

(* Browsers leave the port of HTTP out. *)
let hosts t =
  let names = [ "127.0.0.1"; "localhost" ] in
  List.map (fun name -> Printf.sprintf "%s:%d" name t.port) names @ if t.port = 80 then names else []

let address t = Printf.sprintf "http://127.0.0.1:%d/%s/" t.port t.secret

(* Takes the same time wherever the first difference is. *)
let same secret text =
  let differences = ref 0 in
  let compare i c = differences := !differences lor (Char.code c lxor Char.code secret.[i]) in
  String.length text = String.length secret
  && begin
    String.iteri compare text;
    !differences = 0
  end

let without_query resource =
  match String.index_opt resource '?' with Some i -> String.sub resource 0 i | None -> resource

let granted t ~resource ~host ~origin =
  let is_one_of all text = List.exists (String.equal (String.lowercase_ascii text)) all in
  let origins = List.map (fun host -> "http://" ^ host) (hosts t) in
  let path = without_query resource in
  let n = String.length t.secret in
  let below_secret =
    String.length path >= n + 2 && path.[0] = '/' && path.[n + 1] = '/' && same t.secret (String.sub path 1 n)
  in
  if not (Option.fold host ~none:false ~some:(is_one_of (hosts t))) then Error "the request is for another host"
  else if not (Option.fold origin ~none:true ~some:(is_one_of origins)) then
    Error "the request comes from a page of another server"
  else if not below_secret then Error "the address is not the one that scc serve has printed"
  else Ok (String.sub path (n + 2) (String.length path - n - 2))
