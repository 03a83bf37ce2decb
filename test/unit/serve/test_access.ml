(* Who may ask a server. *)

open Scc_serve

let port = 4321
let made ~port = Result.get_ok (Access.make ~port)
let access = made ~port

(* "/SECRET/" *)
let root access = "/" ^ List.nth (String.split_on_char '/' (Access.address access)) 3 ^ "/"

let rest ?(access = access) ?(host = Some "127.0.0.1:4321") ?origin resource =
  Result.to_option (Access.granted access ~resource ~host ~origin)

let is = Alcotest.(check (option string))

let granted () =
  is "the desk" (Some "") (rest (root access));
  is "a page" (Some "view/d1/") (rest (root access ^ "view/d1/"));
  is "without what is asked of the page" (Some "ask") (rest (root access ^ "ask?x=/../y"));
  is "by name" (Some "") (rest ~host:(Some "LocalHost:4321") (root access));
  is "by its own page" (Some "") (rest ~origin:"http://127.0.0.1:4321" (root access));
  let standard = made ~port:80 in
  is "at the port of HTTP" (Some "")
    (rest ~access:standard ~host:(Some "127.0.0.1") ~origin:"http://localhost" (root standard))

let refused () =
  let no what ?host ?origin resource = is what None (rest ?host ?origin resource) in
  no "no secret" "/";
  no "nothing" "";
  no "another secret" (root (made ~port));
  no "the secret without a slash" (String.sub (root access) 0 33);
  no "a query before it" ("/?" ^ root access);
  no "without a host" ~host:None (root access);
  no "another host" ~host:(Some "example.org:4321") (root access);
  no "a host that begins so" ~host:(Some "127.0.0.1:43210") (root access);
  no "without the port" ~host:(Some "127.0.0.1") (root access);
  no "another page" ~origin:"http://example.org" (root access);
  no "a page of another port" ~origin:"http://127.0.0.1:80" (root access);
  no "another protocol" ~origin:"https://127.0.0.1:4321" (root access);
  no "no page that says who it is" ~origin:"null" (root access)

let secrets () =
  let all = List.init 100 (fun _ -> root (made ~port)) in
  Alcotest.(check int) "no two alike" 100 (List.length (List.sort_uniq String.compare all));
  Alcotest.(check bool) "of 32 digits" true (List.for_all (fun s -> String.length s = 34) all)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "serve" [ ("access", [ case "granted" granted; case "refused" refused; case "secrets" secrets ]) ]
