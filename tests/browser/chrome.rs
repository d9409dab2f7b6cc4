//! A headless Chromium and its pages, by the DevTools protocol over two pipes: no port, no foreign library.

use serde_json::{Value, json};
use std::collections::HashMap;
use std::fmt::Display;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::{env, thread};

pub type Failure = String;
pub type Seen<T = ()> = Result<T, Failure>;

/// Beyond this it counts as never coming.
const PATIENCE: Duration = Duration::from_secs(60);

const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

pub fn find() -> Option<PathBuf> {
    // The two pipes take a Unix shell.
    let folders = cfg!(unix).then(|| env::var_os("PATH")).flatten()?;
    let candidates =
        env::split_paths(&folders).flat_map(|folder| NAMES.map(|name| folder.join(name)));
    candidates.into_iter().find(|path| path.is_file())
}

pub struct Browser {
    child: Child,
    requests: Mutex<ChildStdin>,
    inbox: Arc<Inbox>,
    last: AtomicU64,
}

#[derive(Default)]
struct Inbox {
    messages: Mutex<Messages>,
    news: Condvar,
}

#[derive(Default)]
struct Messages {
    answers: HashMap<u64, Value>,
    /// What nobody asked for, by session.
    events: HashMap<String, Vec<Value>>,
}

impl Inbox {
    fn lock(&self) -> MutexGuard<'_, Messages> {
        self.messages.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn put(&self, message: Value) {
        let mut messages = self.lock();
        if let Some(id) = message["id"].as_u64() {
            messages.answers.insert(id, message);
        } else if let Some(session) = message["sessionId"].as_str() {
            let events = messages.events.entry(session.to_owned()).or_default();
            events.push(message);
        }
        self.news.notify_all();
    }

    fn wait<T>(&self, mut find: impl FnMut(&mut Messages) -> Option<T>) -> Option<T> {
        let mut found = None;
        let waiting = |messages: &mut Messages| {
            found = find(messages);
            found.is_none()
        };
        // What counts is whether it was found, not why the waiting ended.
        drop(self.news.wait_timeout_while(self.lock(), PATIENCE, waiting));
        found
    }
}

impl Browser {
    /// With its own data in an empty folder.
    pub fn start(path: &Path, data: &Path) -> Seen<Self> {
        // The browser reads from descriptor 3 and writes to 4; a standard command can only give 0 and 1.
        let mut child = Command::new("sh")
            .args([
                "-c",
                r#"exec "$@" 3<&0 4>&1 </dev/null >/dev/null 2>&1"#,
                "sh",
            ])
            .arg(path)
            .args([
                "--headless=new",
                "--remote-debugging-pipe",
                // Only our own pages are opened, in containers too, where the sandbox has no rights.
                "--no-sandbox",
                "--disable-gpu",
                "--disable-dev-shm-usage",
                "--disable-background-networking",
                "--no-first-run",
                "--host-resolver-rules=MAP * ~NOTFOUND",
            ])
            .arg(format!("--user-data-dir={}", data.display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(said)?;
        let requests = child.stdin.take().ok_or("no pipe to the browser")?;
        let answers = child.stdout.take().ok_or("no pipe from the browser")?;
        let inbox = Arc::<Inbox>::default();
        let filled = Arc::clone(&inbox);
        thread::spawn(move || {
            let parts = BufReader::new(answers).split(0).map_while(Result::ok);
            for message in parts.filter_map(|part| serde_json::from_slice(&part).ok()) {
                filled.put(message);
            }
        });
        Ok(Browser {
            child,
            requests: Mutex::new(requests),
            inbox,
            last: AtomicU64::new(0),
        })
    }

    fn call(&self, session: Option<&str>, method: &str, params: Value) -> Seen<Value> {
        let id = self.last.fetch_add(1, Ordering::Relaxed) + 1;
        let mut request = json!({ "id": id, "method": method, "params": params });
        if let Some(session) = session {
            request["sessionId"] = session.into();
        }
        write!(self.requests.lock().map_err(said)?, "{request}\0").map_err(said)?;
        let answer = self.inbox.wait(|messages| messages.answers.remove(&id));
        let mut answer = answer.ok_or_else(|| format!("no answer to {method}"))?;
        match answer.get("error") {
            Some(error) => Err(format!("{method}: {error}")),
            None => Ok(answer["result"].take()),
        }
    }

    /// Empty, of the size of a screen, in a window that shares no settings with others.
    pub fn page(&self) -> Seen<Page<'_>> {
        let context = self.call(None, "Target.createBrowserContext", json!({}))?;
        let context = text(&context["browserContextId"]);
        let create =
            json!({ "url": "about:blank", "browserContextId": context, "newWindow": true });
        let target = text(&self.call(None, "Target.createTarget", create)?["targetId"]);
        let attach = json!({ "targetId": target, "flatten": true });
        let session = text(&self.call(None, "Target.attachToTarget", attach)?["sessionId"]);
        let mut page = Page {
            browser: self,
            session,
            context,
        };
        for domain in ["Page", "Runtime", "Log", "Network"] {
            page.call(&format!("{domain}.enable"), json!({}))?;
        }
        // Each has the keyboard to itself.
        page.call(
            "Emulation.setFocusEmulationEnabled",
            json!({ "enabled": true }),
        )?;
        page.still(true)?;
        page.resize(1400, 1000)?;
        Ok(page)
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let closed = self.call(None, "Browser.close", json!({}));
        if closed.is_err() {
            let _ = self.child.kill();
        }
        let _ = self.child.wait();
    }
}

pub struct Page<'b> {
    pub browser: &'b Browser,
    session: String,
    context: String,
}

impl Page<'_> {
    pub fn call(&mut self, method: &str, params: Value) -> Seen<Value> {
        self.browser.call(Some(&self.session), method, params)
    }

    /// Nothing may move by itself.
    pub fn still(&mut self, still: bool) -> Seen {
        let value = if still { "reduce" } else { "no-preference" };
        let feature = json!({ "name": "prefers-reduced-motion", "value": value });
        self.call(
            "Emulation.setEmulatedMedia",
            json!({ "features": [feature] }),
        )
        .map(drop)
    }

    pub fn resize(&mut self, width: u32, height: u32) -> Seen {
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600 });
        self.call("Emulation.setDeviceMetricsOverride", size)
            .map(drop)
    }

    /// Waits until the page, its fonts and its explorers are there.
    pub fn open(&mut self, address: &str) -> Seen {
        self.browser.inbox.lock().events.remove(&self.session);
        let answer = self.call("Page.navigate", json!({ "url": address }))?;
        if let Some(error) = answer.get("errorText") {
            return Err(format!("{address}: {error}"));
        }
        // From one fragment to another of the same page nothing is loaded.
        if answer.get("loaderId").is_none() {
            self.wait_for(&format!(
                "location.href === new URL({}).href",
                json!(address)
            ))?;
            self.call("Page.reload", json!({}))?;
        }
        let loaded = |messages: &mut Messages| {
            let mut events = messages.events.get(&self.session)?.iter();
            events
                .any(|event| event["method"] == "Page.loadEventFired")
                .then_some(())
        };
        let late = || format!("{address} is not loaded");
        self.browser.inbox.wait(loaded).ok_or_else(late)?;
        self.wait_for("document.fonts.status === 'loaded'")
    }

    pub fn show_explorer(&mut self) -> Seen {
        self.value("document.querySelector('[data-explorer]')?.nextElementSibling.scrollIntoView({ behavior: 'instant' })")?;
        self.wait_until_shown()?;
        self.value("scrollTo({ top: 0, behavior: 'instant' })")
            .map(drop)
    }

    pub fn wait_until_shown(&mut self) -> Seen {
        self.wait_for(
            "[...document.querySelectorAll('[data-explorer]')].every(host => host.dataset.shown
                 || location.pathname.endsWith('/print.html'))",
        )
    }

    /// A promise is waited for.
    pub fn value(&mut self, expression: &str) -> Seen<Value> {
        let given =
            json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let mut answer = self.call("Runtime.evaluate", given)?;
        match answer.get("exceptionDetails") {
            Some(details) => Err(format!("{expression}: {details}")),
            None => Ok(answer["result"]["value"].take()),
        }
    }

    pub fn texts(&mut self, expression: &str) -> Seen<Vec<String>> {
        let value = self.value(expression)?;
        let list = value.as_array().ok_or(format!("{expression} is no list"))?;
        Ok(list.iter().map(text).collect())
    }

    pub fn wait_for(&mut self, condition: &str) -> Seen {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if self
                .value(condition)
                .is_ok_and(|value| value == json!(true))
            {
                return Ok(());
            }
            thread::sleep(Duration::from_millis(10));
        }
        Err(format!("never true: {condition}"))
    }

    pub fn press(&mut self, key: &str) -> Seen {
        let code = match key {
            "Enter" => 13,
            "ArrowLeft" => 37,
            "ArrowUp" => 38,
            "ArrowRight" => 39,
            "ArrowDown" => 40,
            _ => return Err(format!("the code of {key} is not known here")),
        };
        for kind in ["keyDown", "keyUp"] {
            let mut event =
                json!({ "type": kind, "key": key, "code": key, "windowsVirtualKeyCode": code });
            if key == "Enter" {
                event["text"] = "\r".into();
            }
            self.call("Input.dispatchKeyEvent", event)?;
        }
        Ok(())
    }

    pub fn write(&mut self, given: &str) -> Seen {
        self.call("Input.insertText", json!({ "text": given }))
            .map(drop)
    }

    pub fn drag(&mut self, places: &[[f64; 2]]) -> Seen {
        let (first, last) = match places {
            [first, .., last] | [first @ last] => (first, last),
            [] => return Ok(()),
        };
        let moves = places.iter().map(|place| ("mouseMoved", place));
        let pressed = [("mouseMoved", first), ("mousePressed", first)];
        for (kind, [x, y]) in pressed
            .into_iter()
            .chain(moves)
            .chain([("mouseReleased", last)])
        {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "buttons": 1, "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", event)?;
        }
        Ok(())
    }

    pub fn tap(&mut self, [x, y]: [f64; 2]) -> Seen {
        self.call(
            "Emulation.setTouchEmulationEnabled",
            json!({ "enabled": true }),
        )?;
        for (kind, points) in [
            ("touchStart", json!([{ "x": x, "y": y }])),
            ("touchEnd", json!([])),
        ] {
            self.call(
                "Input.dispatchTouchEvent",
                json!({ "type": kind, "touchPoints": points }),
            )?;
        }
        Ok(())
    }

    /// Since it was opened: errors in scripts and console, and requests to anywhere but the disk.
    pub fn complaints(&mut self) -> Vec<String> {
        let messages = self.browser.inbox.lock();
        let own = messages.events.get(&self.session).into_iter().flatten();
        own.filter_map(|event| {
            let params = &event["params"];
            let bad = match event["method"].as_str()? {
                "Runtime.exceptionThrown" => true,
                "Runtime.consoleAPICalled" => {
                    ["error", "warning", "assert"].contains(&params["type"].as_str()?)
                }
                "Log.entryAdded" => params["entry"]["level"] == "error",
                "Network.requestWillBeSent" => {
                    let address = params["request"]["url"].as_str()?;
                    !["file:", "data:", "blob:", "about:"]
                        .iter()
                        .any(|scheme| address.starts_with(scheme))
                }
                "Network.loadingFailed" => params["canceled"] != true,
                _ => false,
            };
            bad.then(|| params.to_string())
        })
        .collect()
    }
}

impl Drop for Page<'_> {
    fn drop(&mut self) {
        let context = json!({ "browserContextId": self.context });
        // A window that is gone already is closed.
        let _ = self
            .browser
            .call(None, "Target.disposeBrowserContext", context);
        self.browser.inbox.lock().events.remove(&self.session);
    }
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

fn said(error: impl Display) -> Failure {
    error.to_string()
}
