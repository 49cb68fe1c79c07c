// Shows the list in the language that was asked for, else in the one that was chosen at another visit or in another page of
// the site, else in the one of the browser. Without any of these it is the first one.
{
  const languages = document.currentScript.dataset;
  const asked = new URLSearchParams(location.search).get("language");
  let remembered = null;
  try {
    if (asked in languages) localStorage.setItem("meniscus:language", asked);
    remembered = localStorage.getItem("meniscus:language");
  } catch {}
  const language = [asked, remembered, navigator.language.split("-")[0]].find((tag) => tag in languages);
  if (language) {
    document.documentElement.lang = language;
    document.title = languages[language];
  }
}
